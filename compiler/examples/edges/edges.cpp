#include "edges.h"

typedef ap_uint<8> grey_t;

static int distance(grey_t a, grey_t b) { return a > b ? a - b : b - a; }

void edges(hls::stream<pixel_t>& in, hls::stream<pixel_t>& out, int height, int width) {
#pragma HLS INTERFACE axis port = in
#pragma HLS INTERFACE axis port = out
  grey_t rows[2][kMaxWidth];
#pragma HLS ARRAY_PARTITION variable = rows complete dim = 1
  grey_t window[3][3];
#pragma HLS ARRAY_PARTITION variable = window complete dim = 0
ROW:
  for (int y = 0; y < height; ++y) {
  COLUMN:
    for (int x = 0; x < width; ++x) {
#pragma HLS PIPELINE II = 1
#pragma HLS DEPENDENCE variable = rows inter false
      pixel_t pixel = in.read();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j) window[i][j] = window[i][j + 1];
      window[0][2] = rows[0][x];
      window[1][2] = rows[1][x];
      window[2][2] = pixel.data;
      rows[0][x] = window[1][2];
      rows[1][x] = pixel.data;
      int strength = distance(window[1][0], window[1][2]) + distance(window[0][1], window[2][1]);
      pixel.data = y < 2 || x < 2 ? 0 : strength > 255 ? 255 : strength;
      out.write(pixel);
    }
  }
}
