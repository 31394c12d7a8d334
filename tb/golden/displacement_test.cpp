#include "golden/displacement.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

const cv::Size size(40, 3);

/// An image of one grey level.
cv::Mat plain(int level) { return {size, CV_8UC1, cv::Scalar(level)}; }

TEST(Displacement, IsTheDifferenceOverTheGradient) {
  // 12 less 2 of noise over 22 less 2: half a pixel.
  const cv::Mat difference = plain(12), gradient = plain(22);
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 0.45}), plain(moves)));
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 0.5}), plain(stirs)));
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 0.95}), plain(stirs)));
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 1}), plain(rests)));
}

TEST(Displacement, TheBoundGrowsDownTheRows) {
  const cv::Mat motion =
      displacement(plain(12), plain(22), {.noise = 2, .bound_px = 0.4, .bound_step_px = 0.4});
  EXPECT_EQ(motion.at<uchar>(0, 20), moves);
  EXPECT_EQ(motion.at<uchar>(1, 20), stirs);
  EXPECT_EQ(motion.at<uchar>(2, 20), rests);
}

TEST(Displacement, LooksAtSevenColumnsOnEachSide) {
  cv::Mat difference = plain(0);
  difference.at<uchar>(1, 20) = 100;
  difference.at<uchar>(2, 0) = 100;
  const cv::Mat motion = displacement(difference, plain(0), {.noise = 0, .bound_px = 1});
  EXPECT_EQ(cv::countNonZero(motion.row(0)), 0);
  EXPECT_EQ(cv::countNonZero(motion.row(1)), 15);
  EXPECT_EQ(motion.at<uchar>(1, 13), moves);
  EXPECT_EQ(motion.at<uchar>(1, 27), moves);
  EXPECT_EQ(cv::countNonZero(motion.row(2)), 8) << "columns outside the image count nothing";
}

TEST(Displacement, NothingMovesBelowTheNoise) {
  EXPECT_TRUE(equal(displacement(plain(5), plain(0), {.noise = 5, .bound_px = 0}), plain(rests)));
}

TEST(Displacement, KnowsNoMotionWhenSwitchedOff) {
  EXPECT_TRUE(equal(displacement(plain(255), plain(0), {.noise = 255}), plain(unknown_motion)));
}

}  // namespace
}  // namespace floorline::golden
