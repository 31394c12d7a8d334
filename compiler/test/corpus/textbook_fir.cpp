// FIR with run-time coefficients, arrays in and out.
// top: textbook_fir
// expect: memory taps registers 8x32
// expect: operators multiply=1
void textbook_fir(const int c[8], const int x[40], int y[40]) {
  int taps[8] = {0, 0, 0, 0, 0, 0, 0, 0};
#pragma HLS ARRAY_PARTITION variable=taps complete
SAMPLE:
  for (int n = 0; n < 40; ++n) {
    int acc = 0;
  TAP:
    for (int i = 7; i >= 0; --i) {  // expect: loop II=1
      taps[i] = i == 0 ? x[n] : taps[i - 1];
      acc += taps[i] * c[i];
    }
    y[n] = acc;
  }
}
