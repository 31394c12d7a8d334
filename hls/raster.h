/// Walk over a frame in raster order, shared by the kernels that handle one pixel a step.
#ifndef FLOORLINE_HLS_RASTER_H
#define FLOORLINE_HLS_RASTER_H

#include "table.h"
#include "types.h"

namespace floorline {

/// Column u and row v of a raster scan over `height` rows of `width` pixels, at least one: one counter each
/// instead of a product width * height, and one flat loop, so that a pipeline runs across the ends of rows.
/// Whether the scan goes on is known from two comparisons side by side, not from the counters of the next
/// step. Widths up to MAX_WIDTH, heights up to MAX_HEIGHT + 1; the counters hold no more.
template <int MAX_WIDTH, int MAX_HEIGHT>
struct RasterPosition {
  typedef ap_uint<BitWidth<MAX_WIDTH - 1>::value> Column;
  typedef ap_uint<BitWidth<MAX_HEIGHT>::value> Row;

  Column u;
  Row v;
  Column last_column;
  Row last_row;
  bool inside;

  RasterPosition(Size width, Size height)
      : u(0), v(0), last_column(width - 1), last_row(height - 1), inside(true) {}

  bool at_row_end() const { return u == last_column; }

  void advance() {
#pragma HLS INLINE
    if (at_row_end()) {
      inside = inside && v != last_row;
      u = 0;
      v = v + 1;
    } else {
      u = u + 1;
    }
  }
};

/// A function linear in u and v, walked in raster order with one addition a step.
struct LinearWalk {
  ap_int<32> value;
  ap_int<32> row_start;
  ap_int<32> step;      ///< Change a column.
  ap_int<32> row_step;  ///< Change a row.

  LinearWalk(ap_int<32> start, ap_int<32> per_column, ap_int<32> per_row)
      : value(start), row_start(start), step(per_column), row_step(per_row) {}

  void advance(bool row_end) {
#pragma HLS INLINE
    value = (row_end ? row_start : value) + (row_end ? row_step : step);
    if (row_end) row_start = value;
  }
};

}  // namespace floorline

#endif
