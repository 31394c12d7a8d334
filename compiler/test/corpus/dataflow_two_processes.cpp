// Two processes and a stream.
// top: dataflow_two_processes
#include "hls_stream.h"
static void produce(const int a[32], hls::stream<int>& s) {
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    s.write(a[i] * 5);
  }
}
static void consume(hls::stream<int>& s, int b[32]) {
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    b[i] = s.read() - i;
  }
}
void dataflow_two_processes(const int a[32], int b[32]) {
#pragma HLS DATAFLOW
  hls::stream<int> s("s");
#pragma HLS STREAM variable=s depth=4
  produce(a, s);
  consume(s, b);
}
