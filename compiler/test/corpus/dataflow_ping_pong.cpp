// An array between two processes: a ping-pong buffer.
// top: dataflow_ping_pong
#include "hls_stream.h"
static void fill(hls::stream<int>& in, int buffer[16]) {
  for (int i = 0; i < 16; ++i) {  // expect: loop II=1 cycles=16
#pragma HLS PIPELINE II=1
    buffer[i] = in.read();
  }
}
static void reverse(const int buffer[16], hls::stream<int>& out) {
  for (int i = 15; i >= 0; --i) {
#pragma HLS PIPELINE II=1
    out.write(buffer[i]);
  }
}
void dataflow_ping_pong(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  int buffer[16];
  fill(in, buffer);
  reverse(buffer, out);
}
