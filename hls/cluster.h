/// Selection and clustering of floor points: one report an obstacle (the ICVS paper reports one obstacle as
/// two).
///
/// While a frame runs, each line keeps its best point: the one nearest to the robot, since that one decides
/// where it may drive. At frame end the lines are scanned in order of their index. The point of a line joins
/// the obstacle of the line next before it, among the three lines before, whose point lies within `gap` on
/// the floor: an obstacle survives one or two lines without a point on it. Else it starts an obstacle of its
/// own. Obstacles of at least `min_lines` lines with a point on them are reported, in the order of their
/// first line; the representative is the point nearest to the robot, of equally near ones the first. The
/// first and the last line are no neighbours.
///
/// Distances are exact squares of coordinates cut down to Q8.9 (2 mm), so that a difference fits an 18-bit
/// multiplier.
///
/// Cycles: 1 a line at frame start; about 6 a point; at frame end about 20 a line for the scan and 3 for the
/// reports. Points of the next frame wait in their FIFO meanwhile.
#ifndef FLOORLINE_HLS_CLUSTER_H
#define FLOORLINE_HLS_CLUSTER_H

#include "hls_stream.h"
#include "parameters.h"
#include "types.h"

namespace floorline {
namespace clustering {

typedef ap_int<17> Metres;          ///< Q8.9
typedef ap_uint<35> SquaredMetres;  ///< Q17.18

/// Best point of a line; in the scan also the obstacle that starts at the line. Packs into 103 bits: three
/// RAMB18.
struct Candidate {
  Coordinate u;
  Size v;
  Size rows;
  ap_int<24> x;
  ap_int<24> y;
  ap_uint<1> clipped;
  LineIndex last_line;
  ap_uint<9> lines;  ///< Lines with a point on the obstacle; 0: no point, or it joined an obstacle before.
};

/// What the scan remembers of one of the three lines before.
struct Neighbour {
  ap_uint<1> present;
  Metres x;
  Metres y;
  LineIndex obstacle;  ///< First line of the obstacle it is on.
};

inline Metres coarse(ap_int<24> metres) {
#pragma HLS INLINE
  return metres >> 7;
}

inline SquaredMetres squared_length(ap_int<18> x, ap_int<18> y) {
#pragma HLS INLINE
  return SquaredMetres(x * x + y * y);
}

inline SquaredMetres squared_range(ap_int<24> x, ap_int<24> y) {
#pragma HLS INLINE
  return squared_length(coarse(x), coarse(y));
}

/// Puts `here` on the obstacle of a line before it that lies within the gap.
inline void join(Neighbour& here, const Neighbour& before, SquaredMetres squared_gap) {
#pragma HLS INLINE
  const bool near = squared_length(here.x - before.x, here.y - before.y) <= squared_gap;
  if (here.present && before.present && near) here.obstacle = before.obstacle;
}

}  // namespace clustering

/// Points of one frame up to `end` -> obstacles of that frame and an `end` element. gap: metres, Q8.16.
/// Points carry lines below line_count, as those of polar do.
template <int MAX_LINES>
void cluster(hls::stream<FloorPoint>& points, hls::stream<Obstacle>& obstacles, ap_uint<9> line_count,
             ap_uint<24> gap, LineIndex min_lines) {
  using namespace clustering;
  static Candidate candidates[MAX_LINES];
#pragma HLS AGGREGATE variable = candidates
  const ap_uint<17> coarse_gap = gap >> 7;
  const SquaredMetres squared_gap = coarse_gap * coarse_gap;

  // At the start, since a reset in mid-frame leaves the points of that frame behind.
CLEAR:
  for (ap_uint<9> line = 0; line < line_count; ++line) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 0 max = MAX_LINES
    const Candidate none = {0, 0, 0, 0, 0, 0, 0, 0};
    candidates[line] = none;
  }

  FloorPoint point = points.read();
SELECT:
  while (!point.end) {
    const Candidate best = candidates[point.line];
    if (best.lines == 0 || squared_range(point.x, point.y) < squared_range(best.x, best.y)) {
      const Candidate better = {point.u, point.v, point.rows, point.x, point.y, point.clipped, point.line, 1};
      candidates[point.line] = better;
    }
    point = points.read();
  }

  // The three lines before, the nearest first.
  const Neighbour none = {0, 0, 0, 0};
  Neighbour first = none;
  Neighbour second = none;
  Neighbour third = none;
SCAN:
  for (ap_uint<9> line = 0; line < line_count; ++line) {
#pragma HLS LOOP_TRIPCOUNT min = 0 max = MAX_LINES
    Candidate candidate = candidates[line];
    Neighbour here = {candidate.lines != 0, coarse(candidate.x), coarse(candidate.y), LineIndex(line)};
    join(here, third, squared_gap);
    join(here, second, squared_gap);
    join(here, first, squared_gap);  // The next line before comes last and wins.
    if (here.present && here.obstacle != line) {
      const Candidate so_far = candidates[here.obstacle];
      const bool nearer = squared_range(candidate.x, candidate.y) < squared_range(so_far.x, so_far.y);
      Candidate obstacle = nearer ? candidate : so_far;
      obstacle.last_line = line;
      obstacle.lines = so_far.lines + 1;
      candidates[here.obstacle] = obstacle;
      candidate.lines = 0;
      candidates[line] = candidate;
    }
    third = second;
    second = first;
    first = here;
  }

REPORT:
  for (ap_uint<9> line = 0; line < line_count; ++line) {
#pragma HLS LOOP_TRIPCOUNT min = 0 max = MAX_LINES
    const Candidate found = candidates[line];
    if (found.lines != 0 && found.lines >= min_lines) {
      const Obstacle obstacle = {LineIndex(line), found.last_line, found.u,       found.v, found.rows,
                                 found.x,         found.y,         found.clipped, 0};
      obstacles.write(obstacle);
    }
  }
  const Obstacle end = {0, 0, 0, 0, 0, 0, 0, 0, 1};
  obstacles.write(end);
}

}  // namespace floorline

#endif
