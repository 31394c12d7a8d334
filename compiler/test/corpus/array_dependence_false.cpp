// DEPENDENCE inter false: the claim is true, since the two halves never meet.
// top: array_dependence_false
void array_dependence_false(int a[64], unsigned char shift) {
SHIFT:
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1 cycles=33
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=a inter false
    a[i + 32] = a[i] + (shift & 3);
  }
}
