/// Rows of pixels in four banks by parity of row and column, so that the four pixels of any 2x2 cell lie in
/// four RAMs and are read in one step. Shared by frame_ring.h and lens.h.
#ifndef FLOORLINE_HLS_BANKS_H
#define FLOORLINE_HLS_BANKS_H

#include "types.h"

namespace floorline {

/// Row of a ring of ROWS rows, from one that is at most one turn outside.
template <int ROWS>
inline Size wrapped(ap_int<14> row) {
#pragma HLS INLINE
  if (row < 0) return row + ROWS;
  if (row >= ROWS) return row - ROWS;
  return row;
}

/// The row below, in a ring of ROWS rows.
template <int ROWS>
inline Size row_below(Size row) {
#pragma HLS INLINE
  return row == ROWS - 1 ? Size(0) : Size(row + 1);
}

/// What one axis of a cell asks of the even and of the odd banks: the index there, and whether a pixel of the
/// cell lies there at all.
struct BankAxis {
  Size even_index, odd_index;
  bool even_used, odd_used;
};

/// first and second: the two rows (or columns) of the cell, neighbours, in either order.
inline BankAxis bank_axis(Coordinate first, bool first_used, Coordinate second, bool second_used) {
#pragma HLS INLINE
  const bool odd = first[0];
  BankAxis axis;
  axis.even_index = (odd ? second : first) >> 1;
  axis.odd_index = (odd ? first : second) >> 1;
  axis.even_used = odd ? second_used : first_used;
  axis.odd_used = odd ? first_used : second_used;
  return axis;
}

/// The pixels of a cell by parity of row, then column. What is not used is 0.
struct BankCell {
  Pixel even_even, even_odd, odd_even, odd_odd;
};

inline Pixel pixel_of(const BankCell& cell, ap_uint<1> row, ap_uint<1> column) {
#pragma HLS INLINE
  const Pixel in_even_row = column ? cell.even_odd : cell.even_even;
  const Pixel in_odd_row = column ? cell.odd_odd : cell.odd_even;
  return row ? in_odd_row : in_even_row;
}

/// Reads a pixel when it is used; else 0, and the RAM is not touched.
template <int PITCH, int SIZE>
inline Pixel load_pixel(const Pixel (&bank)[SIZE], Size row, bool row_used, Size column, bool column_used) {
#pragma HLS INLINE
  Pixel pixel = 0;
  if (row_used && column_used) pixel = bank[row * PITCH + column];
  return pixel;
}

/// The cell from the banks of even or odd rows, even or odd columns.
template <int PITCH, int SIZE>
inline BankCell load(const Pixel (&even_even)[SIZE], const Pixel (&even_odd)[SIZE],
                     const Pixel (&odd_even)[SIZE], const Pixel (&odd_odd)[SIZE], const BankAxis& rows,
                     const BankAxis& columns) {
#pragma HLS INLINE
  BankCell cell;
  cell.even_even =
      load_pixel<PITCH>(even_even, rows.even_index, rows.even_used, columns.even_index, columns.even_used);
  cell.even_odd =
      load_pixel<PITCH>(even_odd, rows.even_index, rows.even_used, columns.odd_index, columns.odd_used);
  cell.odd_even =
      load_pixel<PITCH>(odd_even, rows.odd_index, rows.odd_used, columns.even_index, columns.even_used);
  cell.odd_odd =
      load_pixel<PITCH>(odd_odd, rows.odd_index, rows.odd_used, columns.odd_index, columns.odd_used);
  return cell;
}

template <int PITCH, int SIZE>
inline void store(Pixel (&even_even)[SIZE], Pixel (&even_odd)[SIZE], Pixel (&odd_even)[SIZE],
                  Pixel (&odd_odd)[SIZE], Size row, Size column, Pixel pixel) {
#pragma HLS INLINE
  const int index = (row >> 1) * PITCH + (column >> 1);
  const bool odd_row = row[0];
  const bool odd_column = column[0];
  if (!odd_row & !odd_column) even_even[index] = pixel;
  if (!odd_row & odd_column) even_odd[index] = pixel;
  if (odd_row & !odd_column) odd_even[index] = pixel;
  if (odd_row & odd_column) odd_odd[index] = pixel;
}

}  // namespace floorline

#endif
