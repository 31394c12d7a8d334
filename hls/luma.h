/// Brightness of a colour pixel: Y = 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601), rounded.
///
/// Weights are 19595, 38470 and 7471 / 65536; they add up to 1, so that a grey pixel keeps its value, and Y
/// is within 1 LSB of the exact sum. Grey cameras send their pixel in the low byte, which then passes
/// unchanged. No borders, no state. II = 1, a frame takes width * height + depth cycles, depth ~4.
#ifndef FLOORLINE_HLS_LUMA_H
#define FLOORLINE_HLS_LUMA_H

#include "hls_stream.h"
#include "raster.h"
#include "types.h"

namespace floorline {

/// Weighted sum as green plus two weighted differences: two multiplications by constants instead of three.
inline Pixel brightness(RgbPixel rgb) {
#pragma HLS INLINE
  const Pixel red = rgb.range(23, 16);
  const Pixel blue = rgb.range(15, 8);
  const Pixel green = rgb.range(7, 0);
  const ap_int<9> red_excess = red - green;
  const ap_int<9> blue_excess = blue - green;
  const ap_int<26> sum = (ap_int<26>(green) << 16) + 19595 * red_excess + 7471 * blue_excess + (1 << 15);
  return sum >> 16;
}

/// in: width * height pixels. out: their brightness, or their low byte when `grey`.
template <int MAX_WIDTH, int MAX_HEIGHT>
void luma(hls::stream<RgbPixel>& in, hls::stream<Pixel>& out, Size width, Size height, ap_uint<1> grey) {
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
    const RgbPixel rgb = in.read();
    out.write(grey ? Pixel(rgb.range(7, 0)) : brightness(rgb));
  }
}

}  // namespace floorline

#endif
