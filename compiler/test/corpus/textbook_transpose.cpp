// Transpose through a local array.
// top: textbook_transpose
// expect: memory block ram 36x32 count=1
#include "hls_stream.h"
void textbook_transpose(hls::stream<int>& in, hls::stream<int>& out) {
  int block[6][6];
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
#pragma HLS PIPELINE II=1
      block[r][c] = in.read();
    }
  for (int c = 0; c < 6; ++c)
    for (int r = 0; r < 6; ++r) {
#pragma HLS PIPELINE II=1
      out.write(block[r][c]);
    }
}
