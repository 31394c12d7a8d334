/// Separable 3x3 filter over a raster stream with replicated borders, shared by gaussian.h and erode.h.
///
/// One RAM holds the two rows above the pixel that comes in, both in one word a column, so that a step costs
/// one read and one write. A step reduces the new column of three pixels to a column value; the last three
/// column values give the output, width + 1 steps after its centre came in.
///
/// II = 1; a frame takes width * height + width + 1 steps + depth, depth ~8.
#ifndef FLOORLINE_HLS_WINDOW_H
#define FLOORLINE_HLS_WINDOW_H

#include "hls_stream.h"
#include "raster.h"
#include "types.h"

namespace floorline {

/// Walk over the pixels that come in, for a window that lags behind by a row and a pixel: it knows of the
/// rows what a window asks. After the last row, one row and one step more flush the last centres, unless the
/// filter passes.
template <int MAX_WIDTH, int MAX_HEIGHT>
struct WindowWalk {
  typedef ap_uint<BitWidth<MAX_WIDTH - 1>::value> Column;

  Column u;
  Column last_column;
  /// With the one at hand, negative modulo 2^bits: a counter that goes up is a carry chain and nothing else.
  ap_int<BitWidth<MAX_HEIGHT>::value> rows_left;
  ap_uint<2> rows_above;  ///< The one at hand; 2: two or more.
  bool takes;             ///< A pixel comes in.
  bool flushes_row;
  bool flushes_corner;

  WindowWalk(Size width, Size height)
      : u(0),
        last_column(width - 1),
        rows_left(-height),
        rows_above(0),
        takes(true),
        flushes_row(false),
        flushes_corner(false) {}

  bool goes_on() const { return takes || flushes_row || flushes_corner; }

  void advance(bool passes) {
#pragma HLS INLINE
    const bool row_end = u == last_column;
    const bool rows_end = row_end && rows_left == -1;
    flushes_corner = row_end && flushes_row;
    flushes_row = row_end ? rows_end && takes && !passes : flushes_row;
    takes = takes && !rows_end;
    u = row_end ? Column(0) : Column(u + 1);
    if (row_end) {
      rows_left = rows_left + 1;
      rows_above = rows_above == 0 ? 1 : 2;
    }
  }
};

/// Filter names the types and the two reductions:
///   typedef ap_uint<..> Element;  stream element, Element::width bits
///   typedef ap_uint<..> Column;   reduced column
///   static Column reduce_column(Element top, Element middle, Element bottom);
///   static Element reduce_row(Column left, Column middle, Column right);
/// in: width * height elements. out: as many; with `passes` the same ones, without delay. Needs width >= 4 in
/// hardware: a column's word is read again `width` steps after it was written.
template <typename Filter, int MAX_WIDTH, int MAX_HEIGHT>
void filter_3x3(hls::stream<typename Filter::Element>& in, hls::stream<typename Filter::Element>& out,
                Size width, Size height, bool passes) {
#pragma HLS INLINE
  typedef typename Filter::Element Element;
  typedef typename Filter::Column Column;
  const int BITS = Element::width;
  // Upper half: row v - 2; lower half: row v - 1.
  static ap_uint<2 * BITS> rows_above[MAX_WIDTH];
#pragma HLS RESOURCE variable = rows_above core = RAM_S2P_BRAM

  Column left = 0;
  Column middle = 0;
PIXELS:
  for (WindowWalk<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.goes_on(); at.advance(passes)) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 4 max = MAX_WIDTH * MAX_HEIGHT + MAX_WIDTH + 1
// True: the word of column u is touched again `width` >= 4 steps later, when its write is done.
#pragma HLS DEPENDENCE variable = rows_above inter false
    const ap_uint<2 * BITS> above = rows_above[at.u];
    const Element centre = above.range(BITS - 1, 0);
    const Element top = at.rows_above == 1 ? centre : Element(above.range(2 * BITS - 1, BITS));
    Element bottom = centre;
    if (at.takes) {
      bottom = in.read();
      rows_above[at.u] = (centre, bottom);
    }
    const Column right = Filter::reduce_column(top, centre, bottom);

    // The centre is column u - 1 of row v - 1, or for u = 0 the last column of row v - 2.
    const bool filled = at.rows_above == 2 || (at.rows_above == 1 && at.u > 0);
    if (passes || filled) {
      const bool first_column = at.u == 1 || at.last_column == 0;
      const bool last_column = at.u == 0;
      const Element filtered =
          Filter::reduce_row(first_column ? middle : left, middle, last_column ? middle : right);
      out.write(passes ? bottom : filtered);
    }
    left = middle;
    middle = right;
  }
}

}  // namespace floorline

#endif
