#include "hls_stream.h"
static void consume(hls::stream<int>& s, hls::stream<int>& out) {
  for (int i = 0; i < 16; ++i) out.write(s.read());
}
void stream_without_producer(hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<int> s;
  consume(s, out);
}
// error: 8:3: stream 's' is read here but no process writes it; every stream of a dataflow function needs both
