/// Gaussian 3x3, sigma 0.8, replicated borders: takes single-pixel noise out of the difference.
///
/// Separable: columns first, then rows. Weights 245, 534, 245 / 1024 (exact: 0.23899, 0.52201, 0.23899); with
/// the column value kept to 8 fraction bits the result is within 1 LSB of the exact one, rounded.
/// II = 1; a frame takes width * height + width + 1 + depth cycles (window.h). Least width in hardware: 4.
#ifndef FLOORLINE_HLS_GAUSSIAN_H
#define FLOORLINE_HLS_GAUSSIAN_H

#include "window.h"

namespace floorline {

/// The sum of three values weighted 245, 534, 245, as 1024 * centre + 245 * (first + last - 2 * centre).
template <int BITS>
inline ap_int<BITS + 11> gaussian_sum(ap_uint<BITS> first, ap_uint<BITS> centre, ap_uint<BITS> last) {
#pragma HLS INLINE
  const ap_int<BITS + 2> curvature = ap_int<BITS + 2>(first) + last - (ap_int<BITS + 2>(centre) << 1);
  return (ap_int<BITS + 11>(centre) << 10) + 245 * curvature;
}

struct GaussianFilter {
  typedef Pixel Element;
  typedef ap_uint<16> Column;  ///< Q8.8.

  static Column reduce_column(Element top, Element middle, Element bottom) {
#pragma HLS INLINE
    return (gaussian_sum<8>(top, middle, bottom) + 2) >> 2;
  }

  static Element reduce_row(Column left, Column middle, Column right) {
#pragma HLS INLINE
    return (gaussian_sum<16>(left, middle, right) + (1 << 17)) >> 18;
  }
};

/// in: width * height pixels. out: as many, blurred.
template <int MAX_WIDTH, int MAX_HEIGHT>
void gaussian(hls::stream<Pixel>& in, hls::stream<Pixel>& out, Size width, Size height) {
  filter_3x3<GaussianFilter, MAX_WIDTH, MAX_HEIGHT>(in, out, width, height, false);
}

}  // namespace floorline

#endif
