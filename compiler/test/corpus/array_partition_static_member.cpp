// The second array of a static object, named in a member function, in registers.
// top: array_partition_static_member
struct Window {
  int rows[2][8];
  int taps[2][3];
  int step(int v, int column) {
#pragma HLS ARRAY_PARTITION variable=rows complete dim=1
#pragma HLS ARRAY_PARTITION variable=taps complete dim=0
    int sum = 0;
    for (int r = 0; r < 2; ++r) {
      for (int t = 0; t < 2; ++t) taps[r][t] = taps[r][t + 1];
      taps[r][2] = rows[r][column];
      for (int t = 0; t < 3; ++t) sum += (t + r) * taps[r][t];
    }
    rows[0][column] = rows[1][column];
    rows[1][column] = v;
    return sum;
  }
};
void array_partition_static_member(const int in[24], int out[24]) {
  static Window window;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 8; ++c) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
      out[8 * i + c] = window.step(in[8 * i + c], c);
    }
}
