// A process reads an array outside twice an iteration; the array between the processes keeps its one port.
// top: dataflow_two_ports
static void first(const int a[64], int between[32]) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    between[i] = a[2 * i] * a[2 * i + 1];
  }
}
static void second(const int between[32], int out[32]) {
  for (int i = 0; i < 16; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE II=2
    out[2 * i] = between[i] - between[31 - i];
    out[2 * i + 1] = between[i];
  }
}
void dataflow_two_ports(const int a[64], int out[32]) {
#pragma HLS DATAFLOW
  int between[32];
  first(a, between);
  second(between, out);
}
