// PIPELINE of a top with ap_ctrl_none: a call begins each cycle, and hands static state to the next.
// top: calls_free_running
// tokens: 1
// calls: 200
#include "ap_int.h"
#include "hls_stream.h"
void calls_free_running(hls::stream<int>& in, hls::stream<int>& out) {  // expect: loop II=1 depth=3 cycles=3
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
  // expect: memory taps none
  static int count = 0;
  static ap_uint<5> n = 3;
  static int taps[4] = {1, 2, 3, 4};
#pragma HLS ARRAY_PARTITION variable=taps complete
  int x = in.read();
  for (int i = 3; i > 0; --i) taps[i] = taps[i - 1];  // expect: loop unrolled
  taps[0] = x;
  if (n == 7) count = 0;
  ++n;
  count += taps[3] * x;
  out.write(count + taps[2]);
}
