// Member arrays of a class, each with its own partition.
// top: array_partition_member
// calls: 3

struct Filter {
  int taps[6];
  int line[4][8];
  int run(int v, int s) {
#pragma HLS ARRAY_PARTITION variable=taps complete
#pragma HLS ARRAY_PARTITION variable=line complete dim=0
    int sum = 0;
    for (int i = 5; i > 0; --i) { taps[i] = taps[i - 1]; sum += taps[i] * i; }
    taps[0] = v;
    for (int r = 3; r > 0; --r)  // expect: loop II=1
      line[r][s & 7] = line[r - 1][s & 7] + line[r][(s + 1) & 7];
    line[0][s & 7] = v;
    return sum + line[3][s & 7] + line[s & 3][3];
  }
};
void array_partition_member(const int in[24], int out[24]) {
  static Filter f;
  for (int i = 0; i < 24; ++i) out[i] = f.run(in[i], i);
}
