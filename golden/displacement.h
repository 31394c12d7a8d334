/// Golden twin of hls/displacement.h: which pixels move against the floor.
#ifndef FLOORLINE_GOLDEN_DISPLACEMENT_H
#define FLOORLINE_GOLDEN_DISPLACEMENT_H

#include <opencv2/core.hpp>

#include "golden/parameters.h"

namespace floorline::golden {

/// 255 where the mean displacement over 15 columns, sum max(0, difference - noise) / sum max(0, gradient -
/// noise), exceeds bound_px + row * bound_step_px; else 0. Columns outside the image count nothing.
/// difference, gradient: CV_8UC1 of one size.
cv::Mat displacement(const cv::Mat& difference, const cv::Mat& gradient,
                     const DisplacementParameters& parameters);

}  // namespace floorline::golden

#endif
