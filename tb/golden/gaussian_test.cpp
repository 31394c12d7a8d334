#include "golden/gaussian.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_image.h"

namespace floorline::golden {
namespace {

/// The definition: weights exp(-d^2 / (2 sigma^2)) over a 3x3 window of sum 1, borders replicated.
double blurred(const cv::Mat& image, int v, int u) {
  const double side = std::exp(-1 / (2 * 0.8 * 0.8));
  const double weights[3] = {side / (1 + 2 * side), 1 / (1 + 2 * side), side / (1 + 2 * side)};
  double sum = 0;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const int y = std::clamp(v + dv, 0, image.rows - 1);
      const int x = std::clamp(u + du, 0, image.cols - 1);
      sum += weights[dv + 1] * weights[du + 1] * image.at<uchar>(y, x);
    }
  }
  return sum;
}

TEST(Gaussian, LiesWithinHalfALevelOfTheExactValue) {
  const cv::Mat image = random_image({31, 19}, CV_8UC1);
  const cv::Mat result = gaussian(image);
  ASSERT_EQ(result.type(), CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u)
      EXPECT_NEAR(result.at<uchar>(v, u), blurred(image, v, u), 0.5 + 1e-3);
  }
}

TEST(Gaussian, KeepsAFlatImage) {
  const cv::Mat flat(8, 9, CV_8UC1, cv::Scalar(137));
  EXPECT_TRUE(equal(gaussian(flat), flat));
}

}  // namespace
}  // namespace floorline::golden
