// Histogram with a one-deep forwarding register: II = 1 without a dependence pragma lie.
// top: stream_histogram_forwarding
#include "hls_stream.h"
void stream_histogram_forwarding(hls::stream<unsigned char>& in, int out[16]) {
  int bins[16];
  for (int i = 0; i < 16; ++i) bins[i] = 0;
  unsigned char last = 0;
  int count = 0;
  for (int i = 0; i < 96; ++i) {
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=bins intra RAW false
    unsigned char bin = in.read() & 15;
    if (bin == last) {
      ++count;
    } else {
      bins[last] = count;
      count = bins[bin] + 1;
    }
    last = bin;
  }
  bins[last] = count;
  for (int i = 0; i < 16; ++i) out[i] = bins[i];
}
