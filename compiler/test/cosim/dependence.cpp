// Equal values behind each other: the claim that iterations do not depend on each other is wrong.
void dependence(const unsigned char values[16], int result[64]) {
  int counts[64];
#pragma HLS DEPENDENCE variable = counts inter false
#pragma HLS BIND_STORAGE variable = counts type = ram_2p
  for (int i = 0; i < 64; ++i) counts[i] = 0;
  for (int i = 0; i < 16; ++i) {
#pragma HLS PIPELINE II = 1
    counts[values[i] & 63] += i;
  }
  for (int i = 0; i < 64; ++i) result[i] = counts[i];
}
