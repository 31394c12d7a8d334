// An extra statement after an inner unrolled loop in a pipelined one.
// top: loop_extra_statement
int loop_extra_statement(const unsigned char a[16]) {
  int taps[4] = {0, 0, 0, 0};
#pragma HLS ARRAY_PARTITION variable=taps complete
  int out = 0, n = 0;
  for (int i = 0; i < 16; ++i) {  // expect: loop II=1 depth=2
#pragma HLS PIPELINE II=1
    for (int k = 3; k > 0; --k) {
#pragma HLS UNROLL
      taps[k] = taps[k - 1];
    }
    taps[0] = a[i];
    out += taps[0] - taps[3];
    ++n;
  }
  return out * n;
}
