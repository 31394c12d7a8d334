/// How far each pixel has moved against the floor: what tells the foot of an obstacle, which does not move,
/// from its body, which does (docs/detection.md).
///
/// An image that is shifted by p pixels differs from itself by p times its gradient, whatever it shows. So
/// over the 2 * REACH + 1 columns around a pixel
///
///     sum max(0, difference - noise) / sum max(0, gradient - noise)
///
/// is the mean displacement in pixels. The pixel moves when that exceeds bound + row * bound_step (the
/// division is a product), it stirs when it exceeds half of that, else it rests, as it does when both sums
/// are 0. With noise = 255 every pixel is unknown. Columns outside the image count nothing. Exact.
///
/// II = 1; a frame takes width * height + REACH + depth cycles, depth ~6. Widths of at least 2 * REACH + 1.
/// One DSP48E1.
#ifndef FLOORLINE_HLS_DISPLACEMENT_H
#define FLOORLINE_HLS_DISPLACEMENT_H

#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"

namespace floorline {
namespace displacement_sums {

/// Columns on each side of a pixel that are looked at.
const int REACH = 7;
const int WINDOW = 2 * REACH + 1;

typedef ap_uint<12> Sum;  ///< Up to WINDOW * 255.

/// Sums over windows of a raster as differences of a running sum; only they must fit the type, the running
/// sum may wrap.
struct WindowSum {
  Sum before[WINDOW];  ///< Running sums up to the pixel 1, 2, ... WINDOW places before the newest.
  Sum row_start;       ///< Running sum at the start of the row that comes in.

  /// Takes the pixel in `column`; returns the sum around the one REACH places before it.
  Sum take(Pixel value, Size column) {
#pragma HLS INLINE
    if (column == 0) row_start = before[0];
    const Sum upto = before[0] + value;
    // Windows of the row before end where that row does, those at the start of a row begin there.
    const Sum last = column < REACH ? row_start : upto;
    const Sum first = column >= REACH && column <= 2 * REACH ? row_start : before[WINDOW - 1];
  SHIFT:
    for (int i = WINDOW - 1; i > 0; --i) {
#pragma HLS UNROLL
      before[i] = before[i - 1];
    }
    before[0] = upto;
    return last - first;
  }
};

inline Pixel above(Pixel value, Pixel noise) {
#pragma HLS INLINE
  return value > noise ? Pixel(value - noise) : Pixel(0);
}

}  // namespace displacement_sums

/// in: width * height changes. out: as many motions.
template <int MAX_WIDTH, int MAX_HEIGHT>
void displacement(hls::stream<Change>& in, hls::stream<Motion>& out, Size width, Size height,
                  const DisplacementParameters& parameters) {
  using namespace displacement_sums;
  WindowSum differences = {};
  WindowSum gradients = {};
  ap_int<24> bound = parameters.bound;
  const bool measured = parameters.noise != 255;
  // Row `height` holds no pixels, just the end of the last row's windows.
  bool windows_wait = true;
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside || windows_wait; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT + REACH
    Change change = {0, 0};
    if (at.inside) change = in.read();
    const Sum moved = differences.take(above(change.difference, parameters.noise), at.u);
    const Sum texture = gradients.take(above(change.gradient, parameters.noise), at.u);
    const ap_int<36> allowed = bound * texture;
    const bool moves = (ap_int<30>(moved) << 16) > allowed;
    const bool stirs = (ap_int<30>(moved) << 17) > allowed;
    const Motion motion = moves ? MOVES : stirs ? STIRS : RESTS;
    if (at.v != 0 || at.u >= REACH) out.write(measured ? motion : Motion(UNKNOWN));
    const bool row_complete = at.v != 0 && at.u == REACH - 1;
    if (row_complete) bound = bound + parameters.bound_step;
    if (row_complete && !at.inside) windows_wait = false;
  }
}

}  // namespace floorline

#endif
