/// Golden twin of hls/cluster.h: one report an obstacle.
#ifndef FLOORLINE_GOLDEN_CLUSTER_H
#define FLOORLINE_GOLDEN_CLUSTER_H

#include <vector>

#include "golden/birdseye.h"

namespace floorline::golden {

/// Lines whose floor points lie together.
struct Obstacle {
  int first_line = 0;
  int last_line = 0;
  FloorPoint nearest;  ///< The representative: the point nearest to the robot.
};

/// Takes of each line its nearest point, and of those the nearest one with all that lie within gap_m of it in
/// x and in y as one obstacle, then the nearest of the rest, and so on, up to 64. Obstacles of fewer than
/// min_lines lines are dropped. The nearest comes first.
std::vector<Obstacle> cluster(const std::vector<FloorPoint>& points, double gap_m, int min_lines);

}  // namespace floorline::golden

#endif
