// A merge: the side to read is decided by data.
// top: stream_conditional_read
#include "hls_stream.h"
void stream_conditional_read(hls::stream<int>& a, hls::stream<int>& b, hls::stream<int>& out) {
  int state = 1;
  for (int i = 0; i < 64; ++i) {
#pragma HLS PIPELINE II=1
    int v = (state & 1) ? a.read() : b.read();
    state = (state >> 1) ^ (v & 7);
    out.write(v);
  }
}
