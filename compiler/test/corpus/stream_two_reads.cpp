// Two reads of one stream in an iteration.
// top: stream_two_reads
#include "hls_stream.h"
void stream_two_reads(hls::stream<short>& in, hls::stream<int>& out) {
  for (int i = 0; i < 32; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE II=2
    int a = in.read();
    int b = in.read();
    out.write(a * b);
  }
}
