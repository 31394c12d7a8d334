#include "hls_stream.h"
static void produce(hls::stream<int>& s, int n) {
  for (int i = 0; i < 8; ++i) s.write(i + n);
}
static void consume(hls::stream<int>& s, hls::stream<int>& out) {
  for (int i = 0; i < 8; ++i) out.write(s.read());
}
void pragma_bad_depth(hls::stream<int>& out, int n) {
#pragma HLS DATAFLOW
  hls::stream<int> s;
#pragma HLS STREAM variable=s depth=-3
  produce(s, n);
  consume(s, out);
}
// error: 11:9: depth of pragma 'STREAM' must be at least 0
