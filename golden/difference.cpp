#include "golden/difference.h"

namespace floorline::golden {

cv::Mat difference(const PixelPairs& pairs, bool tolerant) {
  cv::Mat distance;
  if (tolerant) {
    // Saturating subtractions: at most one of the two is above 0.
    const cv::Mat above = pairs.current - pairs.high;
    const cv::Mat below = pairs.low - pairs.current;
    distance = above + below;
  } else {
    cv::absdiff(pairs.nearest, pairs.current, distance);
  }
  cv::Mat known;
  cv::bitwise_and(distance, pairs.valid, known);
  return known;
}

}  // namespace floorline::golden
