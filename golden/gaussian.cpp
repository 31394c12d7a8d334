#include "golden/gaussian.h"

#include <opencv2/imgproc.hpp>

namespace floorline::golden {

cv::Mat gaussian(const cv::Mat& image) {
  // CV_32F: OpenCV blurs bytes in fixed point, which would be a second rounding rule.
  cv::Mat exact;
  image.convertTo(exact, CV_32F);
  cv::GaussianBlur(exact, exact, {3, 3}, 0.8, 0.8, cv::BORDER_REPLICATE);
  cv::Mat rounded;
  exact.convertTo(rounded, CV_8U);
  return rounded;
}

}  // namespace floorline::golden
