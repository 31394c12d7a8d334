// An unrolled loop whose break LLVM joins with the last iteration's exit: as many copies as the bound says.
// top: loop_unroll_break_merged
int loop_unroll_break_merged(const unsigned char a[4], unsigned char limit) {
  int sum = 0;
  for (int i = 0; i < 4; i += 2) {  // expect: loop unrolled
#pragma HLS UNROLL
    sum += a[i];
    if (sum > limit) break;
  }
  return sum;
}
