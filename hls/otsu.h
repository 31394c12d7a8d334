/// Histogram and Otsu's threshold (ICVS paper, eq. 9-11): the grey level t that best splits a frame into two
/// classes, p <= t and p > t. The threshold of a frame is used on the next one.
///
/// With q(t) pixels in the lower class, s(t) their sum, N pixels of sum S, the between-class variance is
/// proportional to (N s - q S)^2 / (q (N - q)). Fractions are compared by cross multiplication, without
/// rounding. Between two grey levels that occur every t makes the same split: the lowest of equals is taken.
/// A frame of a single grey level has no split: threshold 0.
///
/// II = 1 while pixels pass; the scan of the histogram clears it for the next frame.
#ifndef FLOORLINE_HLS_OTSU_H
#define FLOORLINE_HLS_OTSU_H

#include "hls_stream.h"
#include "raster.h"
#include "table.h"
#include "types.h"

namespace floorline {

/// in: width * height pixels. out: the same ones. thresholds: one a frame, before its first pixel: the
/// threshold found on the frame before, 0 on the first frame.
template <int MAX_WIDTH, int MAX_HEIGHT>
void otsu(hls::stream<Pixel>& in, hls::stream<Pixel>& out, hls::stream<Pixel>& thresholds, Size width,
          Size height) {
  typedef ap_uint<BitWidth<MAX_WIDTH * MAX_HEIGHT>::value> Count;
  typedef ap_uint<Count::width + 8> Sum;
  static Count histogram[256];
#pragma HLS RESOURCE variable = histogram core = RAM_S2P_BRAM
  static Pixel threshold = 0;
  thresholds.write(threshold);

  // The bins of the last two pixels, newest first: their counts may still be on the way into the RAM. A
  // cleared histogram holds 0 for pixel 0, so that is a true start.
  Pixel pixel1 = 0, pixel2 = 0;
  Count count1 = 0, count2 = 0;
  Count total = 0;
  Sum total_sum = 0;
PIXELS:
  for (RasterPosition at(width); at.v < height; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
// True: a bin written by one of the last two pixels is not read but taken from count1 or count2.
#pragma HLS DEPENDENCE variable = histogram inter RAW distance = 3 true
    const Pixel pixel = in.read();
    out.write(pixel);
    Count count;
    if (pixel == pixel1) {
      count = count1;
    } else if (pixel == pixel2) {
      count = count2;
    } else {
      count = histogram[pixel];
    }
    count = count + 1;
    histogram[pixel] = count;
    pixel2 = pixel1;
    count2 = count1;
    pixel1 = pixel;
    count1 = count;
    total = total + 1;
    total_sum = total_sum + pixel;
  }

  Count below = 0;
  Sum below_sum = 0;
  ap_uint<2 * (Sum::width + Count::width)> best_squared = 0;
  ap_uint<2 * Count::width> best_product = 1;
  threshold = 0;
BINS:
  for (ap_uint<9> t = 0; t < 256; ++t) {
    const Count count = histogram[t];
    histogram[t] = 0;
    below = below + count;
    below_sum = below_sum + count * t;
    if (count == 0 || below == total) continue;
    const ap_int<Sum::width + Count::width + 1> deviation = total * below_sum - below * total_sum;
    const ap_uint<2 * (Sum::width + Count::width)> squared = deviation * deviation;
    const ap_uint<2 * Count::width> product = below * (total - below);
    if (squared * best_product > best_squared * product) {
      best_squared = squared;
      best_product = product;
      threshold = t;
    }
  }
}

}  // namespace floorline

#endif
