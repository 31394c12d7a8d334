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
void dataflow_in_loop(hls::stream<int>& in, hls::stream<int>& out) {
  for (int round = 0; round < 4; ++round) {
#pragma HLS DATAFLOW
    hls::stream<int> middle;
    square(in, middle);
    offset(middle, out, round);
  }
}
// error: 13:9: DATAFLOW acts in a function; put the loop into each process and DATAFLOW into the function that calls them
