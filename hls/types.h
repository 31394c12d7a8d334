/// Element types of the streams between the kernels. Formats: docs/architecture.md.
#ifndef FLOORLINE_HLS_TYPES_H
#define FLOORLINE_HLS_TYPES_H

#include "ap_int.h"

namespace floorline {

typedef ap_uint<24> RgbPixel;   ///< G in 7:0, B in 15:8, R in 23:16.
typedef ap_uint<8> Pixel;       ///< Luma, difference or blurred difference.
typedef ap_uint<2> Mask;        ///< Bit 1: above the high threshold; bit 0: above the low one.
typedef ap_uint<12> Size;       ///< Width, height, or a count of rows, up to 2048.
typedef ap_int<13> Coordinate;  ///< Column or row; may lie outside the image.
typedef ap_uint<8> LineIndex;   ///< Up to 256 lines.

/// |a - b|.
inline Pixel distance(Pixel a, Pixel b) {
#pragma HLS INLINE
  const ap_int<9> rise = a - b;
  return rise < 0 ? ap_int<9>(-rise) : rise;
}

/// A pixel of the current frame with what the ground homography finds for it in the reference frame.
struct PixelPair {
  Pixel current;
  Pixel reference;   ///< Interpolated at H(u, v).
  Pixel gradient;    ///< Of the reference around H(u, v): the greater difference across a diagonal of the 2x2
                     ///< cell.
  ap_uint<1> valid;  ///< 0: null pixel, no correspondence.
};

/// What displacement.h weighs: how much a pixel changed, and by how much it would for a shift of one pixel.
struct Change {
  Pixel difference;
  Pixel gradient;
};

/// How far a pixel has moved against the floor (displacement.h), by what a foot may seem to have moved.
typedef ap_uint<2> Motion;
const int RESTS = 0;    ///< At most half of that: a foot.
const int STIRS = 1;    ///< More than half of it.
const int UNKNOWN = 2;  ///< Not measured: taken for whatever is asked.
const int MOVES = 3;    ///< More than it: what stands above the floor.

/// One Bresenham line as the polar engine walks it, top to bottom, one row a step (run-slice Bresenham).
/// In row first_row the run starts at first_column and holds first_run pixels; later runs hold slice or slice
/// + 1, the last one last_run.
struct LineSetup {
  Coordinate first_column;
  Size first_row;
  Size last_row;
  Size first_run;
  Size last_run;             ///< Pixels in row last_row: the end point cuts the last run short.
  Size slice;                ///< q: whole columns per row, 0 for steep lines (one pixel a row).
  Size remainder;            ///< Added to the error each row.
  Size divisor;              ///< The error overflows when it reaches this; 1 for lines of a single row.
  Size first_error;          ///< Error in row first_row, below divisor.
  ap_uint<1> leftward;       ///< 1: columns fall as rows grow.
  ap_uint<1> contact_first;  ///< 1: the contact is the first row of a run.
};

/// A contact point in the image: where an obstacle touches the floor.
struct Contact {
  LineIndex line;
  Coordinate u;
  Size v;
  Size rows;           ///< Rows of the run (rule run) or S_c (rule paper).
  ap_uint<1> clipped;  ///< The run reached the last row of the line.
  ap_uint<1> end;      ///< End of frame; all other fields 0.
};

/// A contact point on the floor, robot frame.
struct FloorPoint {
  LineIndex line;
  Coordinate u;
  Size v;
  Size rows;
  ap_int<24> x;  ///< Forward, metres, Q8.16.
  ap_int<24> y;  ///< Left, metres, Q8.16.
  ap_uint<1> clipped;
  ap_uint<1> end;
};

/// One obstacle: neighbouring lines whose floor points lie together.
struct Obstacle {
  LineIndex first_line;
  LineIndex last_line;
  Coordinate u;  ///< The representative contact: the nearest to the robot.
  Size v;
  Size rows;
  ap_int<24> x;  ///< Q8.16 metres.
  ap_int<24> y;
  ap_uint<1> clipped;
  ap_uint<1> end;
};

/// Polar histogram: pixels above the high threshold on one line.
struct LineCount {
  LineIndex line;
  Size count;
  ap_uint<1> end;  ///< Set on the frame's last one; with no lines a lone end element of count 0 comes.
};

}  // namespace floorline

#endif
