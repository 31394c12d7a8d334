// Block banks.
// top: array_partition_block
// expect: memory bank ram 8x32 count=4
int array_partition_block(const int in[32]) {
  int bank[32];
#pragma HLS ARRAY_PARTITION variable=bank block factor=4
  for (int i = 0; i < 32; ++i) bank[i] = in[i] * 3;
  int sum = 0;
  for (int i = 0; i < 8; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    sum += bank[i] + bank[i + 8] - bank[i + 16] + bank[i + 24];
  }
  return sum;
}
