// An array of streams between processes.
// top: stream_array_local
// tokens: 32
#include "hls_stream.h"
static void deal(hls::stream<int>& in, hls::stream<int> lanes[2]) {
  for (int i = 0; i < 16; ++i) {
    lanes[0].write(in.read());
    lanes[1].write(in.read());
  }
}
static void merge(hls::stream<int> lanes[2], hls::stream<int>& out) {
  for (int i = 0; i < 16; ++i) out.write(lanes[0].read() - lanes[1].read());
}
void stream_array_local(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<int> lanes[2];
  deal(in, lanes);
  merge(lanes, out);
}
