// hls::stream<T, DEPTH> between processes.
// top: stream_declared_depth
// tokens: 24
#include "hls_stream.h"
static void first(hls::stream<short>& in, hls::stream<short, 8>& out) {
  for (int i = 0; i < 24; ++i) out.write(in.read() * 3);
}
static void second(hls::stream<short, 8>& in, hls::stream<short>& out) {
  for (int i = 0; i < 24; ++i) out.write(in.read() + 1);
}
void stream_declared_depth(hls::stream<short>& in, hls::stream<short>& out) {
#pragma HLS DATAFLOW
  hls::stream<short, 8> middle("middle");
  first(in, middle);
  second(middle, out);
}
