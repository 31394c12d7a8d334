#include "golden/birdseye.h"

namespace floorline::golden {

std::vector<FloorPoint> birdseye(const std::vector<Contact>& contacts, const cv::Matx33d& floor_from_pixel) {
  std::vector<FloorPoint> points;
  for (const Contact& contact : contacts) {
    const cv::Vec3d floor = floor_from_pixel * cv::Vec3d(contact.u, contact.v, 1);
    points.push_back({contact, floor[0] / floor[2], floor[1] / floor[2]});
  }
  return points;
}

}  // namespace floorline::golden
