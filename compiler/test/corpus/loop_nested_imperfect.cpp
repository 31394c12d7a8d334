// Statements before and after the inner loop.
// top: loop_nested_imperfect
int loop_nested_imperfect(const int a[6][6]) {
  int best = -2147483647 - 1;
  for (int r = 0; r < 6; ++r) {
    int sum = r;
    for (int c = 0; c < 6; ++c) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
      sum += a[r][c] >> 4;
    }
    if (sum > best) best = sum;
  }
  return best;
}
