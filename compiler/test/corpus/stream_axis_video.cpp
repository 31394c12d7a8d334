// AXI4-Stream with side channels.
// top: stream_axis_video
#include "ap_axi_sdata.h"
#include "ap_int.h"
#include "hls_stream.h"
typedef ap_axiu<8, 1, 1, 1> Beat;
void stream_axis_video(hls::stream<Beat>& in, hls::stream<Beat>& out) {
#pragma HLS INTERFACE axis port=in
#pragma HLS INTERFACE axis port=out
  for (int i = 0; i < 40; ++i) {
#pragma HLS PIPELINE II=1
    Beat b = in.read();
    b.data = ~b.data;
    b.last = i % 8 == 7;
    out.write(b);
  }
}
