// A process with state across calls inside a dataflow region.
// top: dataflow_static_state
// calls: 5
#include "hls_stream.h"
static void integrate(hls::stream<int>& in, hls::stream<int>& out) {
  static int sum = 0;
  for (int i = 0; i < 16; ++i) {
#pragma HLS PIPELINE II=1
    sum += in.read();
    out.write(sum);
  }
}
static void differentiate(hls::stream<int>& in, hls::stream<int>& out) {
  static int last = 0;
  for (int i = 0; i < 16; ++i) {
#pragma HLS PIPELINE II=1
    int v = in.read();
    out.write(v - last);
    last = v;
  }
}
void dataflow_static_state(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<int> middle;
  integrate(in, middle);
  differentiate(middle, out);
}
