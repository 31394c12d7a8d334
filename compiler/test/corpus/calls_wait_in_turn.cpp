// A call that waits in a later stage, while one ahead of it uses the port of the same memory.
// top: calls_wait_in_turn
// tokens: 1
// calls: 200
#include "hls_stream.h"
void calls_wait_in_turn(hls::stream<unsigned char>& in, hls::stream<unsigned char>& more,  // expect: loop II=3
                        hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS PIPELINE II=3
  static int words[256];
  int at = in.read();
  int first = words[at];
  if (first & 1) first ^= more.read();
  int second = words[first & 255] * 3 + 1;
  words[at ^ 1] = second + at;
  out.write(second);
}
