#include "golden/difference.h"

namespace floorline::golden {

cv::Mat difference(const PixelPairs& pairs) {
  cv::Mat distance, known;
  cv::absdiff(pairs.reference, pairs.current, distance);
  cv::bitwise_and(distance, pairs.valid, known);
  return known;
}

}  // namespace floorline::golden
