// DEPENDENCE with a distance, in an inlined function that has its own name for the array: a count is read and written again one
// step later, and the next step takes it from a register.
// top: array_dependence_distance
#include "ap_int.h"
#include "hls_stream.h"
static void count(hls::stream<ap_uint<4> >& in, ap_uint<8> counts[16]) {
#pragma HLS INLINE
  ap_uint<4> last = 0;
  ap_uint<8> last_count = 0;
COUNT:
  for (int i = 0; i < 60; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
#pragma HLS DEPENDENCE variable=counts inter RAW distance=2 true
    const ap_uint<4> level = in.read();
    ap_uint<8> now = last_count;
    if (level != last) now = counts[level];
    counts[level] = now + 1;
    last = level;
    last_count = now + 1;
  }
}
void array_dependence_distance(hls::stream<ap_uint<4> >& in, ap_uint<8> out[16]) {
  ap_uint<8> bins[16];
  for (int i = 0; i < 16; ++i) bins[i] = 0;
  count(in, bins);
  for (int i = 0; i < 16; ++i) out[i] = bins[i];
}
