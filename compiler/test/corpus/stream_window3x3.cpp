// A 3x3 maximum over a raster with run-time size.
// top: stream_window3x3
// range: width=1..12
// range: height=1..6
// expect: memory lines ram 12x8 count=2
// expect: memory window none
#include "ap_int.h"
#include "hls_stream.h"
void stream_window3x3(hls::stream<ap_uint<8> >& in, hls::stream<ap_uint<8> >& out, unsigned char width,
                      unsigned char height) {
  ap_uint<8> lines[2][12];
#pragma HLS ARRAY_PARTITION variable=lines complete dim=1
  ap_uint<8> window[3][3];
#pragma HLS ARRAY_PARTITION variable=window complete dim=0
  for (int r = 0; r < height; ++r) {
    for (int c = 0; c < width; ++c) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
      ap_uint<8> p = in.read();
      ap_uint<8> column[3] = {r > 1 ? lines[1][c] : ap_uint<8>(0), r > 0 ? lines[0][c] : ap_uint<8>(0), p};
      lines[1][c] = lines[0][c];
      lines[0][c] = p;
      ap_uint<8> best = 0;
      for (int y = 0; y < 3; ++y) {
        window[y][0] = c > 1 ? window[y][1] : ap_uint<8>(0);
        window[y][1] = c > 0 ? window[y][2] : ap_uint<8>(0);
        window[y][2] = column[y];
        for (int x = 0; x < 3; ++x) best = window[y][x] > best ? window[y][x] : best;
      }
      out.write(best);
    }
  }
}
