/// Two thresholds, two bits a pixel: high for the body of an obstacle's triangle, low for its thin lower tip.
///
/// high = p > th_high, low = p > th_low. th_high = override_high when that is not 0, else Otsu's threshold of
/// the frame before (ICVS paper, eq. 11), but not below `floor`: with no obstacle in view Otsu would split
/// the noise. Exact. II = 1, width * height + depth cycles, depth ~4.
#ifndef FLOORLINE_HLS_BINARIZE_H
#define FLOORLINE_HLS_BINARIZE_H

#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"

namespace floorline {

inline Pixel high_threshold(Pixel otsu, const ThresholdParameters& parameters) {
#pragma HLS INLINE
  if (parameters.override_high != 0) return parameters.override_high;
  return otsu > parameters.floor ? otsu : parameters.floor;
}

/// in: width * height pixels; thresholds: one a frame, before its first pixel. out: width * height masks;
/// threshold_used: th_high, one a frame, after its last pixel.
template <int MAX_WIDTH, int MAX_HEIGHT>
void binarize(hls::stream<Pixel>& in, hls::stream<Pixel>& thresholds, hls::stream<Mask>& out,
              hls::stream<Pixel>& threshold_used, Size width, Size height,
              const ThresholdParameters& parameters) {
  const Pixel high = high_threshold(thresholds.read(), parameters);
  const Pixel low = parameters.low;
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
    const Pixel pixel = in.read();
    out.write((ap_uint<1>(pixel > high), ap_uint<1>(pixel > low)));
  }
  threshold_used.write(high);
}

}  // namespace floorline

#endif
