/// Histogram of a frame, counted while its pixels pass (ICVS paper, the first step of eq. 9-11).
///
/// A count is read, raised and written back. When the next pixel comes the RAM does not have it yet, so the
/// count of the last pixel is kept beside the RAM. II = 1.
#ifndef FLOORLINE_HLS_HISTOGRAM_H
#define FLOORLINE_HLS_HISTOGRAM_H

#include "hls_stream.h"
#include "raster.h"
#include "types.h"

namespace floorline {

const int LEVELS = 256;

/// Pixels of a frame of up to MAX_PIXELS, their number and the sum of their levels.
template <unsigned long MAX_PIXELS>
struct HistogramTotals {
  typedef ap_uint<BitWidth<MAX_PIXELS>::value> Count;
  typedef ap_uint<Count::width + 8> Sum;

  Count pixels;
  Sum sum;
};

/// in: width * height pixels. out: the same ones. histogram: 0 everywhere before, the pixels of each level
/// after.
template <int MAX_WIDTH, int MAX_HEIGHT>
HistogramTotals<MAX_WIDTH * MAX_HEIGHT> count_levels(
    hls::stream<Pixel>& in, hls::stream<Pixel>& out,
    typename HistogramTotals<MAX_WIDTH * MAX_HEIGHT>::Count histogram[LEVELS], Size width, Size height) {
#pragma HLS INLINE
  typedef HistogramTotals<MAX_WIDTH * MAX_HEIGHT> Totals;
  typedef typename Totals::Count Count;
  Totals totals = {0, 0};
  // A cleared histogram holds 0 for pixel 0, so that is a true start.
  Pixel last_pixel = 0;
  Count last_count = 0;
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
// True: a bin written by the last pixel is not read but taken from last_count.
#pragma HLS DEPENDENCE variable = histogram inter RAW distance = 2 true
    const Pixel pixel = in.read();
    out.write(pixel);
    Count count;
    if (pixel == last_pixel) {
      count = last_count;
    } else {
      count = histogram[pixel];
    }
    count = count + 1;
    histogram[pixel] = count;
    last_pixel = pixel;
    last_count = count;
    totals.pixels = totals.pixels + 1;
    totals.sum = totals.sum + pixel;
  }
  return totals;
}

}  // namespace floorline

#endif
