// A static array in registers that nothing writes reads as its initial value.
// top: array_static_unwritten
int array_static_unwritten(unsigned char at) {
  static int words[16];
#pragma HLS ARRAY_PARTITION variable=words complete
  return words[at & 15] + at;
}
