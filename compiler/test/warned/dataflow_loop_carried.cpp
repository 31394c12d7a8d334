// A DATAFLOW function whose calls cannot be processes.
// top: dataflow_loop_carried
static void first(const int a[8], int b[8]) {
  for (int i = 0; i < 8; ++i) b[i] = a[i] + 1;
}
static void second(int b[8], int c[8]) {
  for (int i = 0; i < 8; ++i) c[i] = b[i] * 2;
}
static void third(const int b[8], int d[8]) {
  for (int i = 0; i < 8; ++i) d[i] = b[i] - 1;
}
void dataflow_loop_carried(const int a[8], int c[8], int d[8]) {
#pragma HLS DATAFLOW
  int b[8];
  first(a, b);
  second(b, c);
  third(b, d);
}
// warning: 17:3: DATAFLOW has no effect, the calls run one after the other: array 'b' has two readers; give each pair of processes an array of its own
