// UNROLL factor=4 of a loop whose count is a multiple.
// top: loop_unroll_partial
int loop_unroll_partial(const int a[32]) {
  int sum = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=2 because the pair of ports of 'a'
#pragma HLS UNROLL factor=4
    sum += a[i] * (i & 3);
  }
  return sum;
}
