#include "hls_stream.h"
static void produce(hls::stream<int>& s, int n) {
  for (int i = 0; i < 8; ++i) s.write(i + n);
}
static void consume(hls::stream<int>& s, hls::stream<int>& out) {
  for (int i = 0; i < 8; ++i) out.write(s.read());
}
void dataflow_code_between(hls::stream<int>& out, int n, int& seen) {
#pragma HLS DATAFLOW
  hls::stream<int> s;
  produce(s, n);
  seen = n * 3;
  consume(s, out);
}
// error: 12:8: 'seen' is written between the processes of a dataflow function; write it in a process
