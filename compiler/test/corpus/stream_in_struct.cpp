// Streams as members of a struct passed by reference inside the design.
// top: stream_in_struct
#include "hls_stream.h"
struct Pair {
  hls::stream<int> left;
  hls::stream<int> right;
};
static void divide(hls::stream<int>& in, Pair& pair) {
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    int v = in.read();
    pair.left.write(v >> 1);
    pair.right.write(v & 1);
  }
}
static void join(Pair& pair, hls::stream<int>& out) {
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    out.write(pair.left.read() * 3 - pair.right.read());
  }
}
void stream_in_struct(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  Pair pair;
  divide(in, pair);
  join(pair, out);
}
