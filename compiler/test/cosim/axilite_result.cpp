// A return value, a bundle with a name, ap_ctrl_chain behind registers, and a stream beside them.
#include "hls_stream.h"

int axilite_result(hls::stream<int>& in, hls::stream<int>& out, short count) {
#pragma HLS INTERFACE axis port=in
#pragma HLS INTERFACE axis port=out
#pragma HLS INTERFACE s_axilite port=count bundle=CTRL
#pragma HLS INTERFACE ap_ctrl_chain port=return bundle=CTRL
#pragma HLS INTERFACE s_axilite port=return bundle=CTRL
  int sum = 0;
  for (int i = 0; i < count; i++) {
    int value = in.read();
    sum += value;
    out.write(value * value);
  }
  return sum;
}
