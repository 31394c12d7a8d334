// A diamond: one stream split, two paths, joined again.
// top: dataflow_split_join
#include "hls_stream.h"
static void split(hls::stream<int>& in, hls::stream<int>& even, hls::stream<int>& odd) {
  for (int i = 0; i < 40; ++i) {
#pragma HLS PIPELINE II=1
    int v = in.read();
    if (i & 1)
      odd.write(v);
    else
      even.write(v);
  }
}
static void negate(hls::stream<int>& in, hls::stream<int>& out) {
  for (int i = 0; i < 20; ++i) {
#pragma HLS PIPELINE II=1
    out.write(-in.read());
  }
}
static void join(hls::stream<int>& even, hls::stream<int>& odd, hls::stream<int>& out) {
  for (int i = 0; i < 20; ++i) {  // expect: loop II=2 depth=2
#pragma HLS PIPELINE II=2
    out.write(even.read());
    out.write(odd.read());
  }
}
void dataflow_split_join(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<int> even, odd, negated;
  split(in, even, odd);
  negate(odd, negated);
  join(even, negated, out);
}
