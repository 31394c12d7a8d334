// A two-dimensional argument and a nested loop.
// top: array_two_dimensional
void array_two_dimensional(const int a[4][8], int column_sum[8]) {
  for (int c = 0; c < 8; ++c) {
    int sum = 0;
    for (int r = 0; r < 4; ++r) {
#pragma HLS PIPELINE
      sum += a[r][c];
    }
    column_sum[c] = sum;
  }
}
