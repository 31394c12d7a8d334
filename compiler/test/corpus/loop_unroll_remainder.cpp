// UNROLL factor=3 of 10 iterations: a remainder is left.
// top: loop_unroll_remainder
int loop_unroll_remainder(const int a[10]) {
  int sum = 0;
  for (int i = 0; i < 10; ++i) {
#pragma HLS UNROLL factor=3
    sum = sum * 3 + a[i];
  }
  return sum;
}
