// An array of streams in a struct template between two processes.
// top: stream_array_in_struct
// tokens: 96
#include "ap_int.h"
#include "hls_stream.h"
template <typename T, int N>
struct Lanes {
  hls::stream<T> lane[N];
};
template <int N>
static void spread(hls::stream<ap_uint<8> >& in, Lanes<ap_uint<8>, N>& lanes) {
  for (int i = 0; i < 32; ++i)
    for (int k = 0; k < N; ++k) {
#pragma HLS UNROLL
      lanes.lane[k].write(in.read() + k);
    }
}
template <int N>
static void gather(Lanes<ap_uint<8>, N>& lanes, hls::stream<ap_uint<16> >& out) {
  for (int i = 0; i < 32; ++i) {
    ap_uint<16> sum = 0;
    for (int k = 0; k < N; ++k) sum += lanes.lane[k].read();
    out.write(sum);
  }
}
void stream_array_in_struct(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<16> >& out) {
#pragma HLS DATAFLOW
  Lanes<ap_uint<8>, 3> lanes;
  spread<3>(in, lanes);
  gather<3>(lanes, out);
}
