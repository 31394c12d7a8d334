#include "golden/binarize.h"

#include <algorithm>

namespace floorline::golden {

int high_threshold(const Thresholds& thresholds, int otsu_before) {
  return thresholds.override_high != 0 ? thresholds.override_high : std::max(otsu_before, thresholds.floor);
}

Masks binarize(const cv::Mat& image, int high_threshold, int low_threshold) {
  return {image > high_threshold, image > low_threshold};
}

}  // namespace floorline::golden
