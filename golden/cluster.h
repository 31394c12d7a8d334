/// Golden twin of hls/cluster.h: one report an obstacle.
#ifndef FLOORLINE_GOLDEN_CLUSTER_H
#define FLOORLINE_GOLDEN_CLUSTER_H

#include <vector>

#include "golden/birdseye.h"

namespace floorline::golden {

/// Neighbouring lines whose floor points lie together.
struct Obstacle {
  int first_line = 0;
  int last_line = 0;
  FloorPoint nearest;  ///< The representative: the point nearest to the robot.
};

/// Joins points of neighbouring lines that lie nearer than gap_m; obstacles of fewer than min_lines lines are
/// dropped.
std::vector<Obstacle> cluster(const std::vector<FloorPoint>& points, double gap_m, int min_lines);

}  // namespace floorline::golden

#endif
