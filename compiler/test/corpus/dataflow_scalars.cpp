// Scalars reach every process, and may change from call to call.
// top: dataflow_scalars
// calls: 6
// range: n=0..30
#include "hls_stream.h"
static void scale(hls::stream<int>& in, hls::stream<int>& out, unsigned char n, short gain) {
  for (int i = 0; i < n; ++i) {
#pragma HLS PIPELINE II=1
    out.write(in.read() * gain);
  }
}
static void shift(hls::stream<int>& in, hls::stream<int>& out, unsigned char n, short offset) {
  for (int i = 0; i < n; ++i) {
#pragma HLS PIPELINE II=1
    out.write(in.read() + offset);
  }
}
void dataflow_scalars(hls::stream<int>& in, hls::stream<int>& out, unsigned char n, short gain, short offset) {
#pragma HLS DATAFLOW
  hls::stream<int> middle;
  scale(in, middle, n, gain);
  shift(middle, out, n, offset);
}
