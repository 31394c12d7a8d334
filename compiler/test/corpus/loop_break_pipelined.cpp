// break out of a pipelined loop: no iteration after it may take effect.
// top: loop_break_pipelined
int loop_break_pipelined(const unsigned char a[32], unsigned char out[32]) {
  int n = 0;
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    if ((a[i] & 31) == 0) break;
    out[i] = a[i];
    ++n;
  }
  return n;
}
