#include "hls/displacement.h"

#include <cmath>
#include <map>

#include "golden/displacement.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const cv::Mat& difference, const cv::Mat& gradient, const golden::DisplacementParameters& p) {
  hls::stream<Change> changes("changes");
  hls::stream<Motion> motions("motions");
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
  displacement<640, 480>(changes, motions, difference.cols, difference.rows, parameters);
  EXPECT_TRUE(changes.empty());
  cv::Mat result(difference.size(), CV_8UC1);
  for (uchar& grey : cv::Mat_<uchar>(result)) {
    const Motion motion = motions.read();
    grey = motion == RESTS   ? golden::rests
           : motion == STIRS ? golden::stirs
           : motion == MOVES ? golden::moves
                             : golden::unknown_motion;
  }
  EXPECT_TRUE(motions.empty());
  return result;
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
  std::map<int, long> pixels;
  for (const cv::Size size : {cv::Size(15, 1), {16, 16}, {17, 5}, {64, 48}, {640, 480}}) {
    for (int seed = 0; seed < 8; ++seed) {
      const cv::Mat gradient = noise(size, seed) / (1 + 4 * (seed % 3));
      const cv::Mat difference = shifted(gradient, seed);
      const golden::DisplacementParameters parameters = {
          .noise = 3 * (seed % 4), .bound_px = 0.25 * seed, .bound_step_px = (seed - 3) / 1024.0};
      const cv::Mat expected = golden::displacement(difference, gradient, parameters);
      worst = std::max(worst, greatest_difference(run(difference, gradient, parameters), expected));
      for (const int motion : {golden::rests, golden::stirs, golden::moves})
        pixels[motion] += cv::countNonZero(expected == motion);
    }
  }
  for (const auto& [motion, count] : pixels) EXPECT_GT(count, 100000) << "motion " << motion;
  expect_figure("displacement_differs", worst, 0);
}

TEST(Displacement, HoldsTheGreatestSums) {
  const cv::Mat white(20, 64, CV_8UC1, cv::Scalar(255));
  const auto all = [&](int noise, double bound_px, int motion) {
    return cv::countNonZero(run(white, white, {.noise = noise, .bound_px = bound_px}) == motion) == 64 * 20;
  };
  EXPECT_TRUE(all(0, 127, golden::rests));
  EXPECT_TRUE(all(0, 1.99, golden::stirs));
  EXPECT_TRUE(all(0, 0.99, golden::moves));
  EXPECT_TRUE(all(255, 0, golden::unknown_motion)) << "switched off";
}

}  // namespace
}  // namespace floorline
