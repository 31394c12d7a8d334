/// Erosion 3x3 of the high bit: a pixel stays set when its whole neighbourhood is. The low bit passes.
///
/// Outside the image counts as set, as in cv::erode. Replicated borders give the same minimum, since they
/// only repeat pixels that the window holds anyway. Exact. II = 1. With erode_high a frame takes width *
/// height + width + 1 + depth cycles (window.h; least width in hardware: 4), without width * height + depth.
#ifndef FLOORLINE_HLS_ERODE_H
#define FLOORLINE_HLS_ERODE_H

#include "window.h"

namespace floorline {

struct ErosionFilter {
  typedef Mask Element;
  typedef Mask Column;

  /// Bit 1: the AND of the three high bits; bit 0: the centre's low bit.
  static Mask reduce_column(Mask top, Mask middle, Mask bottom) {
#pragma HLS INLINE
    const Mask all = top & middle & bottom;
    return (ap_uint<1>(all[1]), ap_uint<1>(middle[0]));
  }

  static Mask reduce_row(Mask left, Mask middle, Mask right) {
#pragma HLS INLINE
    return reduce_column(left, middle, right);
  }
};

/// in: width * height masks. out: as many; without `erode_high` the same ones, without delay.
template <int MAX_WIDTH, int MAX_HEIGHT>
void erode(hls::stream<Mask>& in, hls::stream<Mask>& out, Size width, Size height, ap_uint<1> erode_high) {
  filter_3x3<ErosionFilter, MAX_WIDTH, MAX_HEIGHT>(in, out, width, height, !erode_high);
}

}  // namespace floorline

#endif
