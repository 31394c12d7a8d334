// Three reads and a write of one array outside go through two ports in two cycles; reads of a word that an
// iteration before wrote come behind the write.
// top: array_two_ports_in_place
void array_two_ports_in_place(int a[32], int taps) {
  for (int i = 0; i < 29; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE
    a[i] = a[i + 1] + a[i + 2] * taps + a[i + 3];
  }
  for (int i = 1; i < 31; ++i) {
#pragma HLS PIPELINE
    if (taps & 1) a[i] += a[i - 1];
    else a[i + 1] -= a[i];
  }
}
