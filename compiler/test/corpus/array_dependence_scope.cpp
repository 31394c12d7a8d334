// DEPENDENCE holds in the loop it stands in and in no other: the sums of the first loop meet, the halves of the second do not.
// top: array_dependence_scope
void array_dependence_scope(int a[64], const unsigned char at[32]) {
SUMS:
  for (int i = 0; i < 32; ++i) {  // expect: loop II=2 because must be ready for
#pragma HLS PIPELINE
    a[at[i] & 3] += i;
  }
HALVES:
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=a inter false
    a[i + 32] = a[i] + 1;
  }
}
