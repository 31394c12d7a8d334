// Calls that read and write a static table: its ports allow II = 2, in which a call still ends without the next.
// top: calls_table
// tokens: 1
// calls: 200
#include "hls_stream.h"
void calls_table(hls::stream<unsigned char>& in, hls::stream<int>& out) {  // expect: loop II=2
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS PIPELINE II=2
  static int counts[256];
  int at = in.read();
  int now = counts[at] + 1;
  counts[at] = now;
  out.write(now * at);
}
