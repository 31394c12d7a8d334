#include "golden/displacement.h"

#include <opencv2/imgproc.hpp>

namespace floorline::golden {
namespace {

constexpr int window_columns = 15;

/// Sums of what exceeds the noise over the window around each pixel, CV_32F.
cv::Mat window_sums(const cv::Mat& image, int noise) {
  cv::Mat above, sums;
  cv::subtract(image, noise, above);  // saturates at 0
  cv::boxFilter(above, sums, CV_32F, {window_columns, 1}, {-1, -1}, false, cv::BORDER_CONSTANT);
  return sums;
}

}  // namespace

cv::Mat displacement(const cv::Mat& difference, const cv::Mat& gradient,
                     const DisplacementParameters& parameters) {
  const cv::Mat moved = window_sums(difference, parameters.noise);
  const cv::Mat texture = window_sums(gradient, parameters.noise);
  cv::Mat moves(difference.size(), CV_8UC1);
  for (int row = 0; row < moves.rows; ++row) {
    const double bound = parameters.bound_px + row * parameters.bound_step_px;
    for (int u = 0; u < moves.cols; ++u) {
      moves.at<uchar>(row, u) = moved.at<float>(row, u) > bound * texture.at<float>(row, u) ? 255 : 0;
    }
  }
  return moves;
}

}  // namespace floorline::golden
