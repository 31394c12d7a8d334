// A line buffer at II = 1: vertical difference of a 12 pixel wide image.
// top: stream_line_buffer
// expect: memory line ram 12x8
#include "ap_int.h"
#include "hls_stream.h"
void stream_line_buffer(hls::stream<ap_uint<8> >& in, hls::stream<ap_int<9> >& out) {
  ap_uint<8> line[12];
  for (int c = 0; c < 12; ++c) line[c] = 0;
  for (int r = 0; r < 8; ++r) {
    for (int c = 0; c < 12; ++c) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
      ap_uint<8> p = in.read();
      out.write(p - line[c]);
      line[c] = p;
    }
  }
}
