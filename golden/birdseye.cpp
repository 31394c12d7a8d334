#include "golden/birdseye.h"

#include <algorithm>
#include <cmath>

namespace floorline::golden {

std::vector<FloorPoint> birdseye(const std::vector<Contact>& contacts, const cv::Matx33d& floor_from_pixel) {
  std::vector<FloorPoint> points;
  for (const Contact& contact : contacts) {
    const cv::Vec3d floor = floor_from_pixel * cv::Vec3d(contact.u, contact.v, 1);
    if (!denominator_resolved(floor[2])) continue;
    const double x = floor[0] / floor[2];
    const double y = floor[1] / floor[2];
    if (std::max(std::abs(x), std::abs(y)) < farthest_m) points.push_back({contact, x, y});
  }
  return points;
}

}  // namespace floorline::golden
