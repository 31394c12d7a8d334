// A static shift register: FIR with constant coefficients.
// top: state_shift_register
// calls: 20
// expect: memory taps registers 8x16
// expect: operators multiply=0
int state_shift_register(short x) {
  static short taps[8];
#pragma HLS ARRAY_PARTITION variable=taps complete
  static const short c[8] = {1, -3, 7, 20, 20, 7, -3, 1};
  int acc = 0;
SHIFT:
  for (int i = 7; i >= 0; --i) {
#pragma HLS UNROLL
    taps[i] = i == 0 ? x : taps[i - 1];
    acc += taps[i] * c[i];
  }
  return acc;
}
