// DEPENDENCE intra RAW false: the word that is written is never the one that is read in the same iteration.
// top: array_dependence_intra
void array_dependence_intra(const unsigned char in[128], int counts[64]) {
  int local[64];
#pragma HLS DEPENDENCE variable=local intra RAW false
  for (int i = 0; i < 64; ++i) local[i] = 0;
  int old = in[0] & 63, sum = 0;
  for (int i = 0; i < 128; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE II=1
    int value = in[i] & 63;
    if (old == value) {
      sum = sum + 1;
    } else {
      local[old] = sum;
      sum = local[value] + 1;
    }
    old = value;
  }
  local[old] = sum;
  for (int i = 0; i < 64; ++i) counts[i] = local[i];
}
