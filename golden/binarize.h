/// Golden twin of hls/binarize.h: two thresholds, two masks.
#ifndef FLOORLINE_GOLDEN_BINARIZE_H
#define FLOORLINE_GOLDEN_BINARIZE_H

#include <opencv2/core.hpp>

#include "golden/parameters.h"

namespace floorline::golden {

/// CV_8UC1 images of 0 and 255: the two bits of the kernels' Mask.
struct Masks {
  cv::Mat high;  ///< Above the high threshold.
  cv::Mat low;   ///< Above the low threshold.
};

/// The high threshold of a frame: override_high when set, else Otsu's of the frame before, but not below the
/// floor.
int high_threshold(const Thresholds& thresholds, int otsu_before);

/// high: p > high_threshold; low: p > low_threshold.
Masks binarize(const cv::Mat& image, int high_threshold, int low_threshold);

}  // namespace floorline::golden

#endif
