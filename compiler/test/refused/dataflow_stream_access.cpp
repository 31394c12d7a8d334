#include "hls_stream.h"
static void consume(hls::stream<int>& in, int b[8]) {
  for (int i = 0; i < 8; ++i) b[i] = in.read();
}
void dataflow_stream_access(hls::stream<int>& out, int b[8]) {
#pragma HLS DATAFLOW
  hls::stream<int> s;
  s.write(1);
  consume(s, b);
}
// error: 8:5: this access to a stream stands between the processes of a dataflow function; move it into a function of its own
