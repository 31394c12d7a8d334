// Scalars in, scalars out and a return value without any handshake.
#include "ap_int.h"

bool free_running_scalars(ap_uint<16> requests, ap_uint<5>* first, ap_uint<16>* grant) {
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS INTERFACE ap_none port=requests
#pragma HLS INTERFACE ap_none port=first
#pragma HLS INTERFACE ap_none port=grant
  ap_uint<5> lowest = 16;
  for (int i = 15; i >= 0; i--) {
#pragma HLS UNROLL
    if (requests[i]) lowest = i;
  }
  *first = lowest;
  *grant = requests & (~requests + 1);
  return requests.xor_reduce();
}
