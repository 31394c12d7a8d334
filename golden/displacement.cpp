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
  cv::Mat motion(difference.size(), CV_8UC1, cv::Scalar(unknown_motion));
  if (parameters.noise == 255) return motion;
  for (int row = 0; row < motion.rows; ++row) {
    const double bound = parameters.bound_px + row * parameters.bound_step_px;
    for (int u = 0; u < motion.cols; ++u) {
      const double allowed = bound * texture.at<float>(row, u), by = moved.at<float>(row, u);
      motion.at<uchar>(row, u) = by > allowed ? moves : 2 * by > allowed ? stirs : rests;
    }
  }
  return motion;
}

}  // namespace floorline::golden
