/// Frame store and ground homography: pairs each pixel of the current frame I_n+1 with its counterpart in the
/// reference frame I_n (ICVS paper, eq. 8), while the current frame may replace the reference.
///
/// Store. A ring of MAX_HEIGHT + MARGIN rows instead of two frames. A replacing frame starts right below the
/// reference, so that its row v overwrites row v - (ring rows - height) of it; rows further down are alive.
/// Four banks by parity of row and column: the 2x2 cell around a mapped point lies in four banks and is read
/// in one step. Row y of a frame lies in ring row (base + y) mod ring rows.
///
/// Map. X, Y (Q14.18) and Z (Q4.28) are linear in u and v and are accumulated. x = width / 2 + X / Z and
/// y = height / 2 + Y / Z come from one reciprocal (reciprocal.h) and one multiplication each, within 0.03 px
/// for images up to 2048 columns, rounded to 64ths of a pixel. What the reciprocal lacks grows with X and Y,
/// which is why they count from the middle of the image.
///
/// Pair: reference, interpolated linearly in the cell at floor(x), floor(y) and rounded; gradient, the
/// greater difference across a diagonal of the cell (Roberts' cross: |dI/dx| + |dI/dy| of the interpolated
/// patch in its middle). Pixels of the cell outside the image repeat those inside. valid when 2^-4 < Z < 8,
/// the pixel nearest to (x, y) is in the image, and both rows of the cell are alive. Not valid: reference and
/// gradient are 0 and the pixel counts as null pixel. The first frame and frames of a size other than the
/// reference's have no valid pixel; such a frame drops the reference even when it does not replace it.
///
/// II = 1; a frame takes width * height + depth cycles, depth ~20. Two DSPs beside the reciprocal's one, and
/// three small products.
#ifndef FLOORLINE_HLS_FRAME_RING_H
#define FLOORLINE_HLS_FRAME_RING_H

#include "banks.h"
#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"
#include "reciprocal.h"
#include "table.h"

namespace floorline {

typedef ap_uint<6> Place;  ///< Within a pixel, 64ths.

/// The two pixels on both sides of a coordinate on one axis of an image: the cell along that axis.
struct AxisCell {
  Size first;
  Size second;  ///< first + 1, or `first` where one of both would be outside the image.
  Place place;  ///< Of the coordinate between both.
  bool inside;  ///< The pixel nearest to the coordinate is inside the image; if not, the rest is meaningless.
  bool single;  ///< second == first.
};

/// from_middle: coordinate less extent / 2, in 128ths of a pixel, rounded down.
inline AxisCell axis_cell(ap_int<26> from_middle, Size extent) {
#pragma HLS INLINE
  const ap_int<26> rounded = (from_middle + 1) >> 1;
  const ap_int<20> below = (rounded >> 6) + (extent >> 1);
  const Size last = extent - 1;
  AxisCell cell;
  cell.place = Place(rounded);
  const bool upper_half = cell.place[5];  // The nearest pixel is the one after `below`.
  const bool before_first = below == -1;
  cell.inside =
      (below >= 0 || (before_first && upper_half)) && (below < last || (below == last && !upper_half));
  cell.single = before_first || below == last;
  cell.first = before_first ? Size(0) : Size(below);
  cell.second = cell.single ? cell.first : Size(cell.first + 1);
  return cell;
}

/// 64 times the value between a and b.
inline ap_uint<14> between(Pixel a, Pixel b, Place place) {
#pragma HLS INLINE
  const ap_int<9> rise = b - a;
  return (ap_uint<14>(a) << 6) + rise * place;
}

/// Reference and gradient from a cell whose pixels are given row by row.
inline void interpolate(Pixel upper_left, Pixel upper_right, Pixel lower_left, Pixel lower_right,
                        Place across, Place down, PixelPair& pair) {
#pragma HLS INLINE
  const ap_uint<14> upper = between(upper_left, upper_right, across);
  const ap_uint<14> lower = between(lower_left, lower_right, across);
  const ap_int<15> rise = lower - upper;
  const ap_uint<20> sum = (ap_uint<20>(upper) << 6) + rise * down + (1 << 11);
  pair.reference = sum >> 12;
  const Pixel falling = distance(upper_left, lower_right);
  const Pixel rising = distance(upper_right, lower_left);
  pair.gradient = falling > rising ? falling : rising;
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
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
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
    const AxisCell column = axis_cell(quotient<17>(x_walk.value >> 7, denominator), width);
    const AxisCell row = axis_cell(quotient<17>(y_walk.value >> 7, denominator), height);
    const bool alive = !replace_reference || row.first + spare_rows > at.v;
    pair.valid = has_reference && denominator.valid && column.inside && row.inside && alive;

    const Size first_row = wrapped<RING_ROWS>(base + row.first);
    const Size second_row = wrapped<RING_ROWS>(base + row.second);
    const BankAxis rows = bank_axis(first_row, pair.valid, second_row, pair.valid && !row.single);
    const BankAxis columns = bank_axis(column.first, true, column.second, !column.single);
    const BankCell cell = load<PITCH>(even_even, even_odd, odd_even, odd_odd, rows, columns);
    interpolate(pixel_of(cell, first_row[0], column.first[0]), pixel_of(cell, first_row[0], column.second[0]),
                pixel_of(cell, second_row[0], column.first[0]),
                pixel_of(cell, second_row[0], column.second[0]), column.place, row.place, pair);
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
