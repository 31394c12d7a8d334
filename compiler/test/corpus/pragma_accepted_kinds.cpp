// Pragmas that ask for what holds anyway.
// top: pragma_accepted_kinds
struct Item {
  short value;
  unsigned char tag;
};
int pragma_accepted_kinds(const Item items[16], const Item packed[16], int n) {
#pragma HLS DISAGGREGATE variable = items
#pragma HLS DATA_PACK variable = packed
#pragma HLS STABLE variable = n
#pragma HLS FUNCTION_INSTANTIATE variable = n
#pragma HLS EXPRESSION_BALANCE off
#pragma HLS LATENCY max = 64
  int kept[64];
#pragma HLS BIND_STORAGE variable = kept type = ram_1p impl = lutram
  int again[64];
#pragma HLS RESOURCE variable = again core = RAM_2P_BRAM
  int sum = 0;
LOOP:
  for (int i = 0; i < (n & 15); ++i) {
#pragma HLS LOOP_TRIPCOUNT min = 0 max = 15
    kept[i] = items[i].value * packed[i].tag;
    again[i] = packed[i].value + items[i].tag;
  }
  for (int i = 0; i < (n & 15); ++i) {
#pragma HLS LOOP_TRIPCOUNT max = 15
    sum += kept[i] ^ again[i];
  }
  return sum;
}
