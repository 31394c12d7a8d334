// Two writes to one stream in an iteration.
// top: stream_two_writes
#include "hls_stream.h"
void stream_two_writes(hls::stream<short>& in, hls::stream<short>& out) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=2 because the stream 'out'
#pragma HLS PIPELINE
    short v = in.read();
    out.write(v);
    if (v & 1) out.write(-v);
  }
}
