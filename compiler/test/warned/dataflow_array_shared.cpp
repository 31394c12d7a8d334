// A DATAFLOW function whose calls cannot be processes.
// top: dataflow_array_shared
static void low(const int a[16], int b[8]) {
  for (int i = 0; i < 8; ++i) b[i] = a[i];
}
static void high(const int a[16], int b[8]) {
  for (int i = 0; i < 8; ++i) b[i] = a[i + 8];
}
void dataflow_array_shared(const int a[16], int b[8], int c[8]) {
#pragma HLS DATAFLOW
  low(a, b);
  high(a, c);
}
// warning: 12:3: DATAFLOW has no effect, the calls run one after the other: array 'a' is used by two processes; let the first pass it on in a local array
