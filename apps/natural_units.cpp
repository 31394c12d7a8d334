#include "natural_units.h"

namespace floorline::app {
namespace {

golden::Contact natural(const Contact& contact) {
  return {contact.line.to_int(), contact.u.to_int(), contact.v.to_int(), contact.rows.to_int(),
          contact.clipped != 0};
}

golden::FloorPoint natural(const FloorPoint& point) {
  const golden::Contact contact{point.line.to_int(), point.u.to_int(), point.v.to_int(), point.rows.to_int(),
                                point.clipped != 0};
  return {contact, metres(point.x), metres(point.y)};
}

/// The kernel does not send the line of the nearest point; the first line stands in its place.
golden::Obstacle natural(const Obstacle& obstacle) {
  const int first = obstacle.first_line.to_int();
  const golden::Contact nearest{first, obstacle.u.to_int(), obstacle.v.to_int(), obstacle.rows.to_int(),
                                obstacle.clipped != 0};
  return {first, obstacle.last_line.to_int(), {nearest, metres(obstacle.x), metres(obstacle.y)}};
}

template <typename Natural, typename Fixed>
std::vector<Natural> all_natural(const std::vector<Fixed>& items) {
  std::vector<Natural> result;
  for (const Fixed& item : items) result.push_back(natural(item));
  return result;
}

}  // namespace

double metres(const ap_int<24>& q8_16) { return q8_16.to_int() / 65536.0; }

std::vector<golden::Contact> in_natural_units(const std::vector<Contact>& contacts) {
  return all_natural<golden::Contact>(contacts);
}

std::vector<golden::FloorPoint> in_natural_units(const std::vector<FloorPoint>& points) {
  return all_natural<golden::FloorPoint>(points);
}

std::vector<golden::Obstacle> in_natural_units(const std::vector<Obstacle>& obstacles) {
  return all_natural<golden::Obstacle>(obstacles);
}

}  // namespace floorline::app
