// One dimension in registers, the other in memory: line buffers.
// top: array_partition_dim
// expect: memory lines ram 16x32 count=3
int array_partition_dim(const int in[16]) {
  static int lines[3][16];
#pragma HLS ARRAY_PARTITION variable=lines complete dim=1
  int sum = 0;
  for (int c = 0; c < 16; ++c) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    sum += lines[0][c] - lines[1][c] + lines[2][c];
    lines[2][c] = lines[1][c];
    lines[1][c] = lines[0][c];
    lines[0][c] = in[c];
  }
  return sum;
}
