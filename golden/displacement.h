/// Golden twin of hls/displacement.h: how far each pixel has moved against the floor.
#ifndef FLOORLINE_GOLDEN_DISPLACEMENT_H
#define FLOORLINE_GOLDEN_DISPLACEMENT_H

#include <opencv2/core.hpp>

#include "golden/parameters.h"

namespace floorline::golden {

/// Motion of a pixel as a grey level.
constexpr uchar rests = 0, unknown_motion = 64, stirs = 128, moves = 255;

/// moves where the mean displacement over 15 columns, sum max(0, difference - noise) / sum max(0, gradient -
/// noise), exceeds bound_px + row * bound_step_px; stirs where it exceeds half of that; else rests. Unknown
/// everywhere when noise = 255. Columns outside the image count nothing. difference, gradient: CV_8UC1 of one
/// size.
cv::Mat displacement(const cv::Mat& difference, const cv::Mat& gradient,
                     const DisplacementParameters& parameters);

}  // namespace floorline::golden

#endif
