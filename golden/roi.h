/// Golden twin of hls/roi.h: the rows in which floor can be seen.
#ifndef FLOORLINE_GOLDEN_ROI_H
#define FLOORLINE_GOLDEN_ROI_H

#include "golden/binarize.h"

namespace floorline::golden {

/// Both masks with 0 outside rows first_row to last_row (inclusive).
Masks roi(const Masks& masks, int first_row, int last_row);

}  // namespace floorline::golden

#endif
