// UNROLL where there is no loop.
// top: pragma_unroll_outside_loop
int pragma_unroll_outside_loop(int a) {
#pragma HLS UNROLL
  return a + 1;
}
