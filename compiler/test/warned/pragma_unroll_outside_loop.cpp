// UNROLL where there is no loop.
// top: pragma_unroll_outside_loop
int pragma_unroll_outside_loop(int a) {
#pragma HLS UNROLL
  return a + 1;
}
// warning: 4:9: pragma 'UNROLL' stands in no loop and has no effect; move it into the body of one
