// Moving average over a stream with a running sum.
// top: textbook_moving_average
// tokens: 40
#include "hls_stream.h"
void textbook_moving_average(hls::stream<short>& in, hls::stream<short>& out) {
  static short window[8];
#pragma HLS ARRAY_PARTITION variable=window complete
  static int sum = 0;
  for (int i = 0; i < 40; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    short x = in.read();
    sum += x - window[7];
    for (int k = 7; k > 0; --k) window[k] = window[k - 1];
    window[0] = x;
    out.write(sum >> 3);
  }
}
