#include "hls/displacement.h"

#include <cmath>

#include "golden/displacement.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const cv::Mat& difference, const cv::Mat& gradient, const golden::DisplacementParameters& p) {
  hls::stream<Change> changes("changes");
  hls::stream<ap_uint<1>> moves("moves");
  for (int v = 0; v < difference.rows; ++v) {
    for (int u = 0; u < difference.cols; ++u) {
      const Change change = {difference.at<uchar>(v, u), gradient.at<uchar>(v, u)};
      changes.write(change);
    }
  }
  DisplacementParameters parameters;
  parameters.noise = p.noise;
  parameters.bound = static_cast<int>(std::lround(std::ldexp(p.bound_px, 16)));
  parameters.bound_step = static_cast<int>(std::lround(std::ldexp(p.bound_step_px, 16)));
  displacement<640, 480>(changes, moves, difference.cols, difference.rows, parameters);
  EXPECT_TRUE(changes.empty());
  return 255 * receive(difference.size(), moves);
}

/// Differences that are about `displacement` times the gradients, patch by patch.
cv::Mat shifted(const cv::Mat& gradient, int seed) {
  cv::RNG random(seed);
  cv::Mat difference = gradient.clone();
  for (int u = 0; u < gradient.cols; u += 11) {
    cv::Mat patch = difference(cv::Rect(u, 0, std::min(11, gradient.cols - u), gradient.rows));
    patch *= random.uniform(0.0, 3.0);
  }
  return difference;
}

TEST(Displacement, EqualsGolden) {
  int worst = 0;
  long moving = 0, still = 0;
  for (const cv::Size size : {cv::Size(15, 1), {16, 16}, {17, 5}, {64, 48}, {640, 480}}) {
    for (int seed = 0; seed < 8; ++seed) {
      const cv::Mat gradient = noise(size, seed) / (1 + 4 * (seed % 3));
      const cv::Mat difference = shifted(gradient, seed);
      const golden::DisplacementParameters parameters = {
          .noise = 3 * (seed % 4), .bound_px = 0.25 * seed, .bound_step_px = (seed - 3) / 1024.0};
      const cv::Mat expected = golden::displacement(difference, gradient, parameters);
      worst = std::max(worst, greatest_difference(run(difference, gradient, parameters), expected));
      moving += cv::countNonZero(expected);
      still += size.area() - cv::countNonZero(expected);
    }
  }
  EXPECT_GT(moving, 100000);
  EXPECT_GT(still, 100000);
  expect_figure("displacement_differs", worst, 0);
}

TEST(Displacement, HoldsTheGreatestSums) {
  const cv::Mat white(20, 64, CV_8UC1, cv::Scalar(255));
  EXPECT_EQ(cv::countNonZero(run(white, white, {.noise = 0, .bound_px = 127})), 0);
  EXPECT_EQ(cv::countNonZero(run(white, white, {.noise = 0, .bound_px = 0.99})), 64 * 20);
  EXPECT_EQ(cv::countNonZero(run(white, white, {.noise = 255, .bound_px = 0})), 0) << "switched off";
}

}  // namespace
}  // namespace floorline
