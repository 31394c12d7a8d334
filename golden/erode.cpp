#include "golden/erode.h"

#include <opencv2/imgproc.hpp>

namespace floorline::golden {

Masks erode(const Masks& masks) {
  Masks eroded;
  cv::erode(masks.high, eroded.high, cv::Mat::ones(3, 3, CV_8U));
  eroded.low = masks.low;
  return eroded;
}

}  // namespace floorline::golden
