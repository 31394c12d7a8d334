// A 3-D array in banks by its first and last dimension, 5 not divisible by 2.
// top: array_partition_three_dims
// calls: 3
// expect: memory a ram 24x16 count=4

void array_partition_three_dims(const short in[60], short out[60], unsigned s, unsigned t) {
  short a[3][4][5];
#pragma HLS ARRAY_PARTITION variable=a cyclic factor=2 dim=1
#pragma HLS ARRAY_PARTITION variable=a block factor=2 dim=3
  for (int i = 0; i < 60; ++i) a[i / 20][i / 5 % 4][i % 5] = in[i];
  for (int i = 0; i < 3; ++i)
    for (int j = 1; j < 4; ++j)
      for (int k = 0; k < 5; ++k) a[i][j][k] += a[(i + s) % 3][j - 1][(k + t) % 5] - a[1][2][3];
  for (int i = 0; i < 60; ++i) out[i] = a[i % 3][i / 3 % 4][i / 12];
}
