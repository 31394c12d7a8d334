#include "ap_axi_sdata.h"
#include "hls_stream.h"

void late_outputs(hls::stream<ap_axiu<8> >& out, unsigned char first);

int main() {
  hls::stream<ap_axiu<8> > out;
  for (int call = 0; call < 50; ++call) {
    late_outputs(out, call);
    if (out.size() != 4) return 1;
    for (int i = 0; i < 4; ++i) {
      const ap_axiu<8> word = out.read();
      if (word.data != call + i || word.last != (i == 3)) return 1;
    }
  }
  return 0;
}
