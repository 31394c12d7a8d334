// Values that the next iteration takes and this one still needs: the register of the one is the copy of the other.
// top: loop_carried_is_copy
#include "hls_stream.h"
void loop_carried_is_copy(hls::stream<int>& in, hls::stream<int>& out, int scale) {
  int last = 1, before = 2;
  for (int i = 0; i < 48; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    const int value = in.read();
    const int scaled = (value * scale) * (last ^ before);
    out.write(scaled + value + (last << 1) + (before << 2));
    before = last;
    last = value;
  }
}
