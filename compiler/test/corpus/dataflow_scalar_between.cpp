// A scalar that one process sets and two others take.
// top: dataflow_scalar_between
static void measure(const int in[16], int kept[16], int again[16], int* sum, bool& odd) {
  int s = 0;
  for (int i = 0; i < 16; ++i) {
    s += in[i];
    kept[i] = in[i];
    again[i] = in[i] ^ i;
  }
  *sum = s;
  odd = s & 1;
}
static void center(const int kept[16], int sum, int out[16]) {
  for (int i = 0; i < 16; ++i) out[i] = 16 * kept[i] - sum;
}
static void mark(const int again[16], const int& sum, bool odd, int out[16]) {
  for (int i = 0; i < 16; ++i) out[i] = odd ? again[i] + sum : again[i];
}
void dataflow_scalar_between(const int in[16], int out[16], int marked[16]) {
#pragma HLS DATAFLOW
  int kept[16], again[16];
  int sum;
  bool odd;
  measure(in, kept, again, &sum, odd);
  center(kept, sum, out);
  mark(again, sum, odd, marked);
}
