// A free-running top with PIPELINE and nothing outside that could hold it back: co-simulation calls it.
#include "ap_int.h"

void calls_of_sums(ap_uint<8> value, bool clear, ap_uint<16>* sum, bool* is_odd) {
#pragma HLS INTERFACE ap_ctrl_none port = return
#pragma HLS INTERFACE ap_none port = sum
#pragma HLS PIPELINE II = 1
  static ap_uint<16> total = 0;
  total = clear ? ap_uint<16>(value) : ap_uint<16>(total + value);
  *sum = total * value;
  *is_odd = total[0];
}
