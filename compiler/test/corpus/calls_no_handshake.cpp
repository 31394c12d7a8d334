// Without ap_start and streams, each cycle is a call: its arguments are those of the cycle in which it begins.
// top: calls_no_handshake
// calls: 60
#include "ap_int.h"
ap_uint<20> calls_no_handshake(ap_uint<9> a, ap_uint<9> b) {  // expect: loop II=1
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS PIPELINE II=1
  static ap_uint<20> sum = 0;
  sum += a;
  return sum * b;
}
