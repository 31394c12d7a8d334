// A global stream of structs between two processes.
// top: stream_global
#include "hls_stream.h"
struct Pair {
  short low, high;
};
static hls::stream<Pair> pairs("pairs");
static void split(const int in[32]) {
  for (int i = 0; i < 32; ++i) {
    Pair pair;
    pair.low = in[i];
    pair.high = in[i] >> 16;
    pairs.write(pair);
  }
}
static void multiply(int out[32]) {
  for (int i = 0; i < 32; ++i) {
    Pair pair = pairs.read();
    out[i] = pair.low * pair.high;
  }
}
void stream_global(const int in[32], int out[32]) {
#pragma HLS DATAFLOW
  split(in);
  multiply(out);
}
