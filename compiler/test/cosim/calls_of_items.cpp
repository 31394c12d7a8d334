// A free-running top with PIPELINE: one call takes an item, and the next begins in the next cycle.
#include "hls_stream.h"
void calls_of_items(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS INTERFACE axis port = in
#pragma HLS INTERFACE axis port = out
#pragma HLS INTERFACE ap_ctrl_none port = return
#pragma HLS PIPELINE II = 1
  static int sum = 0;
  const int item = in.read();
  sum += item * item;
  out.write(sum);
}
