#include "hls_stream.h"
static void produce(hls::stream<int>& s, int n) {
  for (int i = 0; i < 8; ++i) s.write(i + n);
}
static void consume(hls::stream<int>& s, hls::stream<int>& out) {
  for (int i = 0; i < 16; ++i) out.write(s.read());
}
void stream_two_producers(hls::stream<int>& out, int n) {
#pragma HLS DATAFLOW
  hls::stream<int> s;
  produce(s, n);
  produce(s, n + 1);
  consume(s, out);
}
// error: 12:3: stream 's' has two writers; give each process a stream of its own
