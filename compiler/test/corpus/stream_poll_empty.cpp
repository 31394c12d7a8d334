// empty() and the read behind it belong together: a loop drains its input.
// top: stream_poll_empty
// tokens: 16
#include "hls_stream.h"
void stream_poll_empty(hls::stream<int>& in, hls::stream<int>& out) {
  int taken = 0;
LOOP:
  while (taken < 16) {
#pragma HLS PIPELINE
    if (!in.empty()) {
      out.write(in.read() * 3);
      ++taken;
    }
  }
}
