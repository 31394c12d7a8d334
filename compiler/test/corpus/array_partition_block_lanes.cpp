// Lanes that each work on their own block: the range of the subscript tells the bank.
// top: array_partition_block_lanes
int array_partition_block_lanes(const short in[40]) {
  short table[40];
#pragma HLS ARRAY_PARTITION variable = table block factor = 5
  for (int i = 0; i < 40; ++i) table[i] = in[i] * 3;
  int sum = 0;
  for (int i = 0; i < 8; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II = 1
    for (int lane = 0; lane < 5; ++lane) {
#pragma HLS UNROLL
      sum ^= table[lane * 40 / 5 + i];
    }
  }
  return sum;
}
