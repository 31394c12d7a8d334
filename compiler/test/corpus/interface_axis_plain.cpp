// axis ports of a plain type.
// top: interface_axis_plain
// tokens: 32
#include "ap_int.h"
#include "hls_stream.h"
void interface_axis_plain(hls::stream<ap_uint<12> >& in, hls::stream<ap_uint<12> >& out) {
#pragma HLS INTERFACE axis port=in
#pragma HLS INTERFACE axis port=out
  for (int i = 0; i < 32; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    out.write(in.read() ^ 0x5a5);
  }
}
