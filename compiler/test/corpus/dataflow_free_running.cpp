// ap_ctrl_none: starts again by itself.
// top: dataflow_free_running
// tokens: 1
// calls: 100
#include "hls_stream.h"
static void add(hls::stream<int>& in, hls::stream<int>& out) {  // expect: loop II=1 depth=1
#pragma HLS PIPELINE II=1
  out.write(in.read() + 1);
}
static void twice(hls::stream<int>& in, hls::stream<int>& out) {  // expect: loop II=1 depth=1
#pragma HLS PIPELINE II=1
  out.write(in.read() * 2);
}
void dataflow_free_running(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS DATAFLOW
  hls::stream<int> middle;
  add(in, middle);
  twice(middle, out);
}
