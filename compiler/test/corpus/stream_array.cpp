// An array of streams, chosen at compile time by unrolling.
// top: stream_array
#include "hls_stream.h"
void stream_array(hls::stream<int> in[3], hls::stream<int>& out) {
  for (int i = 0; i < 32; ++i) {
#pragma HLS PIPELINE II=1
    int sum = 0;
    for (int k = 0; k < 3; ++k) {
#pragma HLS UNROLL
      sum += in[k].read() << k;
    }
    out.write(sum);
  }
}
