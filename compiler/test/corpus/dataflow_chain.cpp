// Four processes in a chain, streams in and out.
// top: dataflow_chain
#include "ap_int.h"
#include "hls_stream.h"
template <int K>
static void stage(hls::stream<ap_uint<12> >& in, hls::stream<ap_uint<12> >& out) {
  for (int i = 0; i < 60; ++i) {  // expect: loop II=1 depth=1
#pragma HLS PIPELINE II=1
    out.write(in.read() * K + i);
  }
}
void dataflow_chain(hls::stream<ap_uint<12> >& in, hls::stream<ap_uint<12> >& out) {
#pragma HLS DATAFLOW
  hls::stream<ap_uint<12> > a, b, c;
  stage<3>(in, a);
  stage<5>(a, b);
  stage<7>(b, c);
  stage<9>(c, out);
}
