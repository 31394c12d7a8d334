/// Golden twin of hls/erode.h.
#ifndef FLOORLINE_GOLDEN_ERODE_H
#define FLOORLINE_GOLDEN_ERODE_H

#include "golden/binarize.h"

namespace floorline::golden {

/// 3x3 minimum of the high mask; outside the image counts as set. The low mask passes.
Masks erode(const Masks& masks);

}  // namespace floorline::golden

#endif
