// Cyclic banks by rows, blocks by columns, in a static array; each bank has two read ports.
// top: array_partition_two_dims
// calls: 3
// expect: memory a ram 9x32 count=12

void array_partition_two_dims(const int in[40], int out[40], unsigned s, unsigned t) {
  static int a[5][8];
#pragma HLS ARRAY_PARTITION variable=a cyclic factor=2 dim=1
#pragma HLS ARRAY_PARTITION variable=a block factor=3 dim=2
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 8; ++c) a[r][c] = in[r * 8 + c] + c;
  for (int r = 1; r < 5; ++r)
    for (int c = 0; c < 7; ++c) {
#pragma HLS PIPELINE
      a[r][c] += a[r - 1][c + 1] * 3;
    }
  a[s % 5][t % 8] += 77;
  a[2][3] ^= a[4][7];
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 8; ++c) out[r * 8 + c] = a[r][c] + a[(r + s) % 5][(c + t) % 8];
}
