// A partition named by the parameter of a function that is called with two arrays.
// top: array_partition_argument
// calls: 3

static int total(int x[4][6], int s) {
#pragma HLS ARRAY_PARTITION variable=x block factor=2 dim=1
  int sum = 0;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 6; ++c) sum += x[r][c] * (r + s);
  x[s & 3][2] = sum;
  return sum;
}
static void shift(int row[6], int v) {
  for (int i = 5; i > 0; --i) row[i] = row[i - 1];
  row[0] = v;
}
void array_partition_argument(const int in[24], int out[24]) {
  int a[4][6], b[4][6];
  for (int i = 0; i < 24; ++i) { a[i / 6][i % 6] = in[i]; b[i / 6][i % 6] = -in[i]; }
  for (int i = 0; i < 24; ++i) {
    shift(a[i & 3], in[i]);
    out[i] = total(a, i) - total(b, i + 1);
  }
}
