/// Golden twin of hls/gaussian.h.
#ifndef FLOORLINE_GOLDEN_GAUSSIAN_H
#define FLOORLINE_GOLDEN_GAUSSIAN_H

#include <opencv2/core.hpp>

namespace floorline::golden {

/// Gaussian 3x3 of sigma 0.8, borders replicated, in floating point, rounded to the nearest. CV_8UC1 ->
/// CV_8UC1.
cv::Mat gaussian(const cv::Mat& image);

}  // namespace floorline::golden

#endif
