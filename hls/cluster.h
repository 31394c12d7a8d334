/// Selection and clustering of floor points: one report an obstacle (the ICVS paper reports one obstacle as
/// two).
///
/// While a frame runs, each line keeps its best point: the one nearest to the robot, since that one decides
/// where it may drive. At frame end the nearest of all is taken, and with it the best points of all lines
/// that lie within `gap` of it, ahead as well as sideways: they are one obstacle, whatever the lines between
/// them saw, as both upright edges of a plain box. Then the nearest of the rest, and so on, up to
/// MOST_OBSTACLES. Obstacles of at least `min_lines` lines are reported, the nearest first; of equally near
/// points the one of the first line comes first.
///
/// Distances are exact squares of coordinates cut down to Q8.9 (2 mm), so that they fit an 18-bit multiplier.
///
/// Cycles: 1 a line at frame start; about 6 a point; at frame end line_count + ~6 an obstacle, and as many
/// once more. Points of the next frame wait in their FIFO meanwhile. Six DSP48E1: a range is formed anew
/// wherever it is compared, which costs less than a memory of them.
#ifndef FLOORLINE_HLS_CLUSTER_H
#define FLOORLINE_HLS_CLUSTER_H

#include "hls_stream.h"
#include "parameters.h"
#include "types.h"

namespace floorline {
namespace clustering {

/// More are farther away than anything that matters now.
const int MOST_OBSTACLES = 64;

typedef ap_int<17> Metres;          ///< Q8.9
typedef ap_uint<35> SquaredMetres;  ///< Q17.18

/// Farther than any point: |x|, |y| <= 128 m make 2^33 at most.
const SquaredMetres NOWHERE = -1;

/// Best point of a line. Packs into 86 bits: three RAMB18.
struct Candidate {
  Coordinate u;
  Size v;
  Size rows;
  ap_int<24> x;
  ap_int<24> y;
  ap_uint<1> clipped;
};

inline Metres coarse(ap_int<24> metres) {
#pragma HLS INLINE
  return metres >> 7;
}

/// Of a FloorPoint or a Candidate.
template <typename Point>
inline SquaredMetres squared_range(const Point& point) {
#pragma HLS INLINE
  const Metres x = coarse(point.x), y = coarse(point.y);
  return SquaredMetres(x * x + y * y);
}

/// |a - b| <= gap.
inline bool near(Metres a, Metres b, ap_uint<17> gap) {
#pragma HLS INLINE
  const ap_int<18> apart = a - b;
  return apart <= gap && -apart <= gap;
}

}  // namespace clustering

/// Points of one frame up to `end` -> obstacles of that frame and an `end` element. gap: metres, Q8.16.
/// Points carry lines below line_count, as those of polar do.
template <int MAX_LINES>
void cluster(hls::stream<FloorPoint>& points, hls::stream<Obstacle>& obstacles, ap_uint<9> line_count,
             ap_uint<24> gap, LineIndex min_lines) {
  using namespace clustering;
  static Candidate candidates[MAX_LINES];
  static ap_uint<1> present[MAX_LINES];  ///< 0: the line has no candidate, or it is on an obstacle already.
#pragma HLS AGGREGATE variable = candidates
  const ap_uint<17> coarse_gap = gap >> 7;

  // At the start, since a reset in mid-frame leaves the points of that frame behind.
CLEAR:
  for (ap_uint<9> line = 0; line < line_count; ++line) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 0 max = MAX_LINES
    present[line] = 0;
  }

SELECT:
  for (bool ended = false; !ended;) {
    const FloorPoint point = points.read();
    ended = point.end;
    const bool nearer = squared_range(point) < squared_range(candidates[point.line]);
    if (!ended && (!present[point.line] || nearer)) {
      const Candidate better = {point.u, point.v, point.rows, point.x, point.y, point.clipped};
      candidates[point.line] = better;
      present[point.line] = 1;
    }
  }

  // Each pass takes the obstacle around the point that the pass before found nearest; the first one only
  // looks for it.
  LineIndex nearest = 0;
  bool found = false;
  bool more = true;
TAKE:
  for (ap_uint<7> taken = 0; more && taken <= MOST_OBSTACLES; ++taken) {
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MOST_OBSTACLES + 1
    const Candidate foot = candidates[nearest];
    const Metres x = coarse(foot.x);
    const Metres y = coarse(foot.y);
    LineIndex first_line = 0;
    LineIndex last_line = 0;
    ap_uint<9> lines = 0;
    LineIndex next = 0;
    SquaredMetres next_range = NOWHERE;
  LINES:
    for (ap_uint<9> line = 0; line < line_count; ++line) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 0 max = MAX_LINES
// True: a line is read and then written once a pass.
#pragma HLS DEPENDENCE variable = present inter false
      const Candidate candidate = candidates[line];
      const bool stands = present[line];
      const SquaredMetres range = squared_range(candidate);
      const bool here = found && stands && near(coarse(candidate.x), x, coarse_gap) &&
                        near(coarse(candidate.y), y, coarse_gap);
      if (here) {
        present[line] = 0;
        if (lines == 0) first_line = line;
        last_line = line;
        ++lines;
      } else if (stands && range < next_range) {
        next = line;
        next_range = range;
      }
    }
    if (found && lines >= min_lines) {
      const Obstacle obstacle = {first_line, last_line, foot.u,       foot.v, foot.rows,
                                 foot.x,     foot.y,    foot.clipped, 0};
      obstacles.write(obstacle);
    }
    nearest = next;
    found = next_range != NOWHERE;
    more = found;
  }
  const Obstacle end = {0, 0, 0, 0, 0, 0, 0, 0, 1};
  obstacles.write(end);
}

}  // namespace floorline

#endif
