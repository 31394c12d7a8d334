// One stream in, one out.
// top: stream_copy
#include "ap_int.h"
#include "hls_stream.h"
void stream_copy(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<8> >& out) {
COPY:
  for (int i = 0; i < 64; ++i) {  // expect: loop II=1 depth=1 cycles=64
#pragma HLS PIPELINE II=1
    out.write(in.read() + 1);
  }
}
