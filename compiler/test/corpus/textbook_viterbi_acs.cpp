// Add-compare-select over four states.
// top: textbook_viterbi_acs
unsigned textbook_viterbi_acs(const unsigned char metric[16][4]) {
  unsigned short cost[4] = {0, 99, 99, 99};
#pragma HLS ARRAY_PARTITION variable=cost complete
  unsigned decisions = 0;
  for (int t = 0; t < 16; ++t) {  // expect: loop II=2 because the pair of ports of 'metric'
#pragma HLS PIPELINE
    unsigned short next[4];
#pragma HLS ARRAY_PARTITION variable=next complete
    for (int s = 0; s < 4; ++s) {
#pragma HLS UNROLL
      unsigned short a = cost[s >> 1] + metric[t][s], b = cost[(s >> 1) + 2] + metric[t][s ^ 3];
      next[s] = a <= b ? a : b;
      decisions = decisions * 2 + (a > b);
    }
    for (int s = 0; s < 4; ++s) {
#pragma HLS UNROLL
      cost[s] = next[s];
    }
  }
  return decisions ^ cost[0];
}
