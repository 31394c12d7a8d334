#include "golden/luma.h"

#include <opencv2/imgproc.hpp>

namespace floorline::golden {

cv::Mat luma(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat colours;
  image.convertTo(colours, CV_32F);
  cv::Mat y;
  cv::transform(colours, y, cv::Matx13f(0.114f, 0.587f, 0.299f));
  cv::Mat rounded;
  y.convertTo(rounded, CV_8U);
  return rounded;
}

}  // namespace floorline::golden
