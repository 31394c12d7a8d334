/// The kernels' fixed-point results in the golden model's terms, so that both can be compared and shown
/// alike.
#ifndef FLOORLINE_APPS_NATURAL_UNITS_H
#define FLOORLINE_APPS_NATURAL_UNITS_H

#include <vector>

#include "golden/cluster.h"
#include "hls/types.h"

namespace floorline::app {

/// Q8.16 metres.
double metres(const ap_int<24>& q8_16);

std::vector<golden::Contact> in_natural_units(const std::vector<Contact>& contacts);
std::vector<golden::FloorPoint> in_natural_units(const std::vector<FloorPoint>& points);
std::vector<golden::Obstacle> in_natural_units(const std::vector<Obstacle>& obstacles);

}  // namespace floorline::app

#endif
