// The last outputs wait behind stalls that outlive the run.
#include "ap_axi_sdata.h"
#include "hls_stream.h"

void late_outputs(hls::stream<ap_axiu<8> >& out, unsigned char first) {
#pragma HLS INTERFACE axis port = out
  for (int i = 0; i < 4; ++i) {
    ap_axiu<8> word;
    word.data = first + i;
    word.keep = word.strb = 1;
    word.last = i == 3;
    out.write(word);
  }
}
