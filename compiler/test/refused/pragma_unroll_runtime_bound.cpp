int pragma_unroll_runtime_bound(const int a[64], int n) {
  int sum = 0;
  for (int i = 0; i < n; ++i) {
#pragma HLS UNROLL
    sum += a[i & 63];
  }
  return sum;
}
// error: 3:3: the loop cannot be unrolled because its trip count is not known; give UNROLL a factor, or the loop a constant bound
