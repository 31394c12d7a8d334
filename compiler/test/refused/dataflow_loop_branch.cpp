#include "hls_stream.h"
static void square(hls::stream<int>& in, hls::stream<int>& out) {
  for (int i = 0; i < 8; ++i) {
    int x = in.read();
    out.write(x * x);
  }
}
static void offset(hls::stream<int>& in, hls::stream<int>& out, int add) {
  for (int i = 0; i < 8; ++i) out.write(in.read() + add);
}
void dataflow_loop_branch(hls::stream<int>& in, hls::stream<int>& out, int skip) {
  for (int round = 0; round < 4; ++round) {
#pragma HLS DATAFLOW
    hls::stream<int> middle;
    square(in, middle);
    if (round != skip) offset(middle, out, round);
  }
}
// error: 16:24: this call of a DATAFLOW loop stands in a branch; put the branch into the process
