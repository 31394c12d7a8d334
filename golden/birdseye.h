/// Golden twin of hls/birdseye.h: contact points on the floor.
#ifndef FLOORLINE_GOLDEN_BIRDSEYE_H
#define FLOORLINE_GOLDEN_BIRDSEYE_H

#include <vector>

#include "golden/polar.h"

namespace floorline::golden {

/// A contact on the floor: robot frame, metres.
struct FloorPoint {
  Contact contact;
  double x = 0;  ///< Forward.
  double y = 0;  ///< Left.
};

/// Floor points farther ahead or to a side than this are dropped.
constexpr double farthest_m = 128;

/// Maps each contact by `floor_from_pixel` (ICVS paper, eq. 14-15), scaled so that Z = 1 in the middle of the
/// rows of interest. Contacts whose Z is not resolved (parameters.h) or that lie beyond farthest_m are
/// dropped.
std::vector<FloorPoint> birdseye(const std::vector<Contact>& contacts, const cv::Matx33d& floor_from_pixel);

}  // namespace floorline::golden

#endif
