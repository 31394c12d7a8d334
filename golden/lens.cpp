#include "golden/lens.h"

#include <cmath>

namespace floorline::golden {
namespace {

/// Reads a CV_8UC1 image; outside it everything is 0.
int at(const cv::Mat& image, int x, int y) {
  const bool inside = x >= 0 && x < image.cols && y >= 0 && y < image.rows;
  return inside ? image.at<uchar>(y, x) : 0;
}

uchar nearest(const cv::Mat& image, cv::Point2d p) {
  return static_cast<uchar>(at(image, cvFloor(p.x + 0.5), cvFloor(p.y + 0.5)));
}

uchar bilinear(const cv::Mat& image, cv::Point2d p) {
  const int x = cvFloor(p.x);
  const int y = cvFloor(p.y);
  const double right = p.x - x;
  const double below = p.y - y;
  const double upper_row = std::lerp(at(image, x, y), at(image, x + 1, y), right);
  const double lower_row = std::lerp(at(image, x, y + 1), at(image, x + 1, y + 1), right);
  return cv::saturate_cast<uchar>(std::lerp(upper_row, lower_row, below));
}

}  // namespace

Lens::Lens(const cv::Matx33d& camera_matrix, const std::array<double, 5>& distortion, cv::Size size,
           Interpolation interpolation)
    : camera_matrix_(camera_matrix),
      distortion_(distortion),
      interpolation_(interpolation),
      map_(size, CV_64FC2) {
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) map_.at<cv::Point2d>(v, u) = source(u, v);
  }
}

cv::Point2d Lens::source(double u, double v) const {
  const auto [k1, k2, p1, p2, k3] = distortion_;
  const double focal_x = camera_matrix_(0, 0);
  const double focal_y = camera_matrix_(1, 1);
  const double centre_x = camera_matrix_(0, 2);
  const double centre_y = camera_matrix_(1, 2);
  const double x = (u - centre_x) / focal_x;
  const double y = (v - centre_y) / focal_y;
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double distorted_x = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
  const double distorted_y = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  return {focal_x * distorted_x + centre_x, focal_y * distorted_y + centre_y};
}

cv::Mat Lens::rectify(const cv::Mat& image) const {
  const auto sample = interpolation_ == Interpolation::nearest ? nearest : bilinear;
  cv::Mat rectified(map_.size(), CV_8UC1);
  for (int v = 0; v < map_.rows; ++v) {
    for (int u = 0; u < map_.cols; ++u) rectified.at<uchar>(v, u) = sample(image, map_.at<cv::Point2d>(v, u));
  }
  return rectified;
}

int Lens::ring_radius() const {
  double farthest = 0;
  for (int v = 0; v < map_.rows; ++v) {
    for (int u = 0; u < map_.cols; ++u) {
      const double row = map_.at<cv::Point2d>(v, u).y;
      if (row > -1 && row < map_.rows) farthest = std::max(farthest, std::abs(row - v));
    }
  }
  return cvFloor(farthest) + 1;
}

}  // namespace floorline::golden
