/// The ports around the first difference as waves.
#ifndef FLOORLINE_APPS_WAVE_PICTURE_H
#define FLOORLINE_APPS_WAVE_PICTURE_H

#include <string>

#include "tb/cosim/port_watch.h"

namespace floorline::app {

/// SVG: TVALID, TREADY and TDATA of the port that differs and of every other one that offers something
/// meanwhile, a column a cycle; the element that differs is marked. TDATA shows its last four hexadecimal
/// digits.
std::string wave_picture(const cosim::PortWatch& watch);

}  // namespace floorline::app

#endif
