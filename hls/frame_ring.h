/// Frame store and ground homography: pairs each pixel of the current frame I_n+1 with its counterpart in the
/// reference frame I_n (ICVS paper, eq. 8), while the current frame may replace the reference.
///
/// Store. A ring of MAX_HEIGHT + MARGIN rows instead of two frames. A replacing frame starts right below the
/// reference, so that its row v overwrites row v - (ring rows - height) of it; rows further down are alive.
/// Four banks by parity of row and column: the 2x2 cell around a mapped point lies in four banks and is read
/// in one step. Row y of a frame lies in ring row (base + y) mod ring rows.
///
/// Map. X, Y (Q14.18) and Z (Q4.28) are linear in u and v and are accumulated. x = X / Z and y = Y / Z come
/// from one reciprocal (reciprocal.h) and one multiplication each, within 0.05 px for images up to 2048
/// columns; they are kept in half pixels, which is all that floor(x) and floor(x + 0.5) need.
///
/// Pair: nearest, the pixel at floor(x + 0.5), floor(y + 0.5); low and high, the least and greatest pixel of
/// the cell at floor(x), floor(y), cut to the image. valid when 2^-4 < Z < 8, the nearest pixel is in the
/// image, and both rows of the cell are alive. Not valid: nearest, low, high are 0 and the pixel counts as
/// null pixel. The first frame and frames of a size other than the reference's have no valid pixel; such a
/// frame drops the reference even when it does not replace it.
///
/// II = 1; a frame takes width * height + depth cycles, depth ~20. Two DSPs beside the reciprocal's one.
#ifndef FLOORLINE_HLS_FRAME_RING_H
#define FLOORLINE_HLS_FRAME_RING_H

#include "banks.h"
#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"
#include "reciprocal.h"
#include "table.h"

namespace floorline {

/// The two pixels nearest to a coordinate on one axis of an image: the cell along that axis.
struct AxisCell {
  Size nearest;
  Size other;   ///< The second nearest, or `nearest` where that would be outside the image.
  Size first;   ///< The lesser of both.
  bool inside;  ///< `nearest` is inside the image; if not, the rest is meaningless.
  bool single;  ///< other == nearest.
};

/// half_pixels: floor(2 x), from the 25-bit quotient.
inline AxisCell axis_cell(ap_int<20> half_pixels, Size extent) {
#pragma HLS INLINE
  const ap_int<21> shifted = half_pixels + 1;  // nearest = floor(x + 0.5) = floor((2 x + 1) / 2)
  const ap_int<20> nearest = shifted >> 1;
  const bool cell_goes_up = shifted[0];  // x lies above the centre of its nearest pixel
  const Size last = extent - 1;
  AxisCell cell;
  cell.inside = nearest >= 0 && nearest <= last;
  cell.nearest = nearest;
  cell.single = cell_goes_up ? cell.nearest == last : cell.nearest == 0;
  cell.other = cell.nearest;
  if (!cell.single) cell.other = cell_goes_up ? Size(cell.nearest + 1) : Size(cell.nearest - 1);
  cell.first = cell_goes_up ? cell.nearest : cell.other;
  return cell;
}

/// Widens [low, high] to hold a pixel that belongs to the cell.
inline void widen(PixelPair& pair, Pixel pixel, bool in_cell) {
#pragma HLS INLINE
  if (in_cell && pixel < pair.low) pair.low = pixel;
  if (in_cell && pixel > pair.high) pair.high = pixel;
}

/// nearest, low and high of what the banks hold.
inline void take_cell(const BankCell& cell, const BankAxis& rows, const BankAxis& columns,
                      ap_uint<1> nearest_row, ap_uint<1> nearest_column, PixelPair& pair) {
#pragma HLS INLINE
  pair.nearest = pixel_of(cell, nearest_row, nearest_column);
  pair.low = pair.nearest;
  pair.high = pair.nearest;
  widen(pair, cell.even_even, rows.even_used && columns.even_used);
  widen(pair, cell.even_odd, rows.even_used && columns.odd_used);
  widen(pair, cell.odd_even, rows.odd_used && columns.even_used);
  widen(pair, cell.odd_odd, rows.odd_used && columns.odd_used);
}

/// in: width * height pixels. out: as many pairs. null_pixels: one count a frame, after its last pixel.
template <int MAX_WIDTH, int MAX_HEIGHT, int MARGIN>
void frame_ring(hls::stream<Pixel>& in, hls::stream<PixelPair>& out, hls::stream<ap_uint<24> >& null_pixels,
                Size width, Size height, ap_uint<1> replace_reference, const ProjectiveMap& homography) {
  static_assert(
      MAX_WIDTH % 2 == 0 && MAX_HEIGHT % 2 == 0 && MARGIN % 2 == 0,
      "MAX_WIDTH, MAX_HEIGHT and MARGIN must be even: the ring's banks hold every second row and column.");
  const int RING_ROWS = MAX_HEIGHT + MARGIN;
  const int PITCH = MAX_WIDTH / 2;
  static_assert(BitWidth<RING_ROWS>::value <= Size::width, "MAX_HEIGHT + MARGIN must fit the type Size.");
  const int BANK_SIZE = RING_ROWS / 2 * PITCH;
  static Pixel even_even[BANK_SIZE];
  static Pixel even_odd[BANK_SIZE];
  static Pixel odd_even[BANK_SIZE];
  static Pixel odd_odd[BANK_SIZE];
#pragma HLS RESOURCE variable = even_even core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = even_odd core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = odd_even core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = odd_odd core = RAM_S2P_BRAM
  static Size base = 0;  // ring row of the reference's row 0
  static Size reference_width = 0;
  static Size reference_height = 0;
  static ap_uint<1> has_reference = 0;

  if (width != reference_width || height != reference_height) has_reference = 0;
  reference_width = width;
  reference_height = height;
  const Size next_base = wrapped<RING_ROWS>(base + height);
  const Size spare_rows = RING_ROWS - height;

  // Half a unit of what the 25-bit numerators drop is added, so that they round.
  LinearWalk x_walk(homography.x1 + 64, homography.xu, homography.xv);
  LinearWalk y_walk(homography.y1 + 64, homography.yu, homography.yv);
  LinearWalk z_walk(homography.z1 - 1, homography.zu, homography.zv);
  Size write_row = next_base;
  ap_uint<24> null_count = 0;

PIXELS:
  for (RasterPosition at(width); at.v < height; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
// True: a row that is being overwritten is not alive, and rows that are not alive are not read.
#pragma HLS DEPENDENCE variable = even_even inter RAW false
#pragma HLS DEPENDENCE variable = even_odd inter RAW false
#pragma HLS DEPENDENCE variable = odd_even inter RAW false
#pragma HLS DEPENDENCE variable = odd_odd inter RAW false
    PixelPair pair;
    pair.current = in.read();

    const Reciprocal denominator = reciprocal(z_walk.value);
    const AxisCell column = axis_cell(quotient<23>(x_walk.value >> 7, denominator), width);
    const AxisCell row = axis_cell(quotient<23>(y_walk.value >> 7, denominator), height);
    const bool alive = !replace_reference || row.first + spare_rows > at.v;
    pair.valid = has_reference && denominator.valid && column.inside && row.inside && alive;

    const Size nearest_row = wrapped<RING_ROWS>(base + row.nearest);
    const Size other_row = wrapped<RING_ROWS>(base + row.other);
    const BankAxis rows = bank_axis(nearest_row, pair.valid, other_row, pair.valid && !row.single);
    const BankAxis columns = bank_axis(column.nearest, true, column.other, !column.single);
    const BankCell cell = load<PITCH>(even_even, even_odd, odd_even, odd_odd, rows, columns);
    take_cell(cell, rows, columns, nearest_row[0], column.nearest[0], pair);
    out.write(pair);
    if (!pair.valid) null_count = null_count + 1;

    if (replace_reference)
      store<PITCH>(even_even, even_odd, odd_even, odd_odd, write_row, at.u, pair.current);
    const bool row_end = at.at_row_end();
    x_walk.advance(row_end);
    y_walk.advance(row_end);
    z_walk.advance(row_end);
    if (row_end) write_row = row_below<RING_ROWS>(write_row);
  }

  if (replace_reference) {
    base = next_base;
    has_reference = 1;
  }
  null_pixels.write(null_count);
}

}  // namespace floorline

#endif
