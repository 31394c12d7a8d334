// Read after write at a known distance of 3.
// top: array_raw_distance_three
void array_raw_distance_three(int a[40]) {
CHAIN:
  for (int i = 3; i < 40; ++i) {  // expect: loop II=2 because the read port of 'a'
#pragma HLS PIPELINE
    a[i] = a[i - 3] * 3 + a[i];
  }
}
