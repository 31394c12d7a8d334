// AXI4-Stream elements with a part of the side channels, set by methods, and with fixed-point data.
// top: stream_axis_data
// tokens: 16
#include <ap_axi_sdata.h>
#include <ap_fixed.h>
#include <hls_stream.h>
typedef hls::axis<ap_fixed<16, 8>, 0, 0, 0> Sample;
typedef hls::axis_data<ap_uint<32>, AXIS_ENABLE_LAST | AXIS_ENABLE_KEEP> Word;
void stream_axis_data(hls::stream<Sample>& in, hls::stream<Word>& out) {
#pragma HLS INTERFACE axis port=in
#pragma HLS INTERFACE axis port=out
  for (int i = 0; i < 16; i++) {  // expect: loop II=1
#pragma HLS PIPELINE
    Sample sample = in.read();
    Word word;
    word.set_data(int(sample.data * 16) + sample.get_last());
    word.keep_all();
    word.last = i == 15;
    out.write(word);
  }
}
