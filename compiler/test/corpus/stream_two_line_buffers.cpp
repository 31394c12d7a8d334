// Two chained line buffers at II = 1.
// top: stream_two_line_buffers
// expect: memory above ram 10x8
#include "ap_int.h"
#include "hls_stream.h"
void stream_two_line_buffers(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<10> >& out) {
  static ap_uint<8> above[10], top[10];
  for (int i = 0; i < 100; ++i) {  // expect: loop II=1 depth=2
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=above inter false
#pragma HLS DEPENDENCE variable=top inter false
    int c = i % 10;
    ap_uint<8> p = in.read();
    ap_uint<8> a = above[c], t = top[c];
    out.write(ap_uint<10>(p + a + t));
    top[c] = a;
    above[c] = p;
  }
}
