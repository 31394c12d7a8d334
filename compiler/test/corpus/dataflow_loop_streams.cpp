// A DATAFLOW loop without control signals, and processes without scalars.
// top: dataflow_loop_streams
// tokens: 32
#include "hls_stream.h"
static void square(hls::stream<short>& in, hls::stream<int>& out) {
  for (int i = 0; i < 8; ++i) {
    short x = in.read();
    out.write(x * x);
  }
}
static void offset(hls::stream<int>& in, hls::stream<int>& out) {
  for (int i = 0; i < 8; ++i) out.write(in.read() + i);
}
void dataflow_loop_streams(hls::stream<short>& in, hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_none port = return
  for (int round = 0; round < 4; ++round) {
#pragma HLS DATAFLOW
    hls::stream<int> middle;
    square(in, middle);
    offset(middle, out);
  }
}
