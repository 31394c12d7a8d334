// A filter: fewer tokens out than in.
// top: stream_conditional_write
#include "hls_stream.h"
void stream_conditional_write(hls::stream<int>& in, hls::stream<int>& out) {
  for (int i = 0; i < 64; ++i) {
#pragma HLS PIPELINE II=1
    int v = in.read();
    if (v & 4) out.write(v);
  }
}
