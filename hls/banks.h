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

/// What one axis of a cell asks of the even [0] and the odd [1] banks: the index there, and whether a pixel
/// of the cell lies there at all.
struct BankAxis {
  Size index[2];
  bool used[2];
};

/// first and second: the two rows (or columns) of the cell, neighbours, in either order.
inline BankAxis bank_axis(Coordinate first, bool first_used, Coordinate second, bool second_used) {
#pragma HLS INLINE
  const bool odd = first[0];
  BankAxis axis;
  axis.index[0] = (odd ? second : first) >> 1;
  axis.index[1] = (odd ? first : second) >> 1;
  axis.used[0] = odd ? second_used : first_used;
  axis.used[1] = odd ? first_used : second_used;
  return axis;
}

/// The pixels of a cell by parity of row and column.
struct BankCell {
  Pixel pixel[2][2];
};

/// Banks of PITCH columns each. What is not used reads 0 and is not touched in the RAM.
template <int PITCH, int SIZE>
inline BankCell load(const Pixel (&banks)[2][2][SIZE], const BankAxis& rows, const BankAxis& columns) {
#pragma HLS INLINE
  BankCell cell;
LOAD_ROWS:
  for (int r = 0; r < 2; ++r) {
#pragma HLS UNROLL
  LOAD_COLUMNS:
    for (int c = 0; c < 2; ++c) {
#pragma HLS UNROLL
      cell.pixel[r][c] = 0;
      if (rows.used[r] && columns.used[c]) {
        cell.pixel[r][c] = banks[r][c][rows.index[r] * PITCH + columns.index[c]];
      }
    }
  }
  return cell;
}

template <int PITCH, int SIZE>
inline void store(Pixel (&banks)[2][2][SIZE], Size row, Size column, Pixel pixel) {
#pragma HLS INLINE
STORE_ROWS:
  for (int r = 0; r < 2; ++r) {
#pragma HLS UNROLL
  STORE_COLUMNS:
    for (int c = 0; c < 2; ++c) {
#pragma HLS UNROLL
      if (row[0] == r && column[0] == c) banks[r][c][(row >> 1) * PITCH + (column >> 1)] = pixel;
    }
  }
}

}  // namespace floorline

#endif
