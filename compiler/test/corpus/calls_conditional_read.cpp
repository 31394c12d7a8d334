// A read that depends on another stands in a later stage: it waits without the next call's input.
// top: calls_conditional_read
// tokens: 1
// calls: 200
#include "hls_stream.h"
void calls_conditional_read(hls::stream<int>& in, hls::stream<int>& other,  // expect: loop II=1 depth=5
                            hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
  int x = in.read();
  int y = x * x * 5;
  if (y & 0x40) y += other.read();
  if (y & 4) out.write(y * x);
}
