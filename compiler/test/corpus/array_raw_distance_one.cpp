// Read after write through memory at distance 1: a histogram.
// top: array_raw_distance_one
void array_raw_distance_one(const unsigned char in[64], int histogram[8]) {
  int bins[8];
  for (int i = 0; i < 8; ++i) bins[i] = 0;
COUNT:
  for (int i = 0; i < 64; ++i) {  // expect: loop II=2 because 'bins
#pragma HLS PIPELINE
    bins[in[i] & 7]++;
  }
  for (int i = 0; i < 8; ++i) histogram[i] = bins[i];
}
