// ap_ctrl_none with streams alone: a process that finds nothing to do does not hold up the others.
// top: dataflow_free_running_rates
// tokens: 1
// calls: 100
#include "hls_stream.h"
static void split(hls::stream<int>& in, hls::stream<int>& odd, hls::stream<int>& even) {
  static int count = 0;
  int value = in.read();
  if (++count > 50)
    odd.write(value);
  else
    even.write(value);
}
static void keep_odd(hls::stream<int>& in, hls::stream<int>& out) {
  if (!in.empty()) out.write(in.read() + 1);
}
static void keep_even(hls::stream<int>& in, hls::stream<int>& out) {
  if (!in.empty()) out.write(in.read() + 2);
}
void dataflow_free_running_rates(hls::stream<int>& in, hls::stream<int>& out_odd, hls::stream<int>& out_even) {
#pragma HLS INTERFACE ap_ctrl_none port=return
#pragma HLS DATAFLOW
  hls::stream<int> odd, even;
  split(in, odd, even);
  keep_odd(odd, out_odd);
  keep_even(even, out_even);
}
