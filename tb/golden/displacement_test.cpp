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
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 0.45}), plain(255)));
  EXPECT_TRUE(equal(displacement(difference, gradient, {.noise = 2, .bound_px = 0.5}), plain(0)));
}

TEST(Displacement, TheBoundGrowsDownTheRows) {
  const cv::Mat moves =
      displacement(plain(12), plain(22), {.noise = 2, .bound_px = 0.3, .bound_step_px = 0.125});
  EXPECT_EQ(moves.at<uchar>(0, 20), 255);
  EXPECT_EQ(moves.at<uchar>(1, 20), 255);
  EXPECT_EQ(moves.at<uchar>(2, 20), 0);
}

TEST(Displacement, LooksAtSevenColumnsOnEachSide) {
  cv::Mat difference = plain(0);
  difference.at<uchar>(1, 20) = 100;
  difference.at<uchar>(2, 0) = 100;
  const cv::Mat moves = displacement(difference, plain(0), {.noise = 0, .bound_px = 1});
  EXPECT_EQ(cv::countNonZero(moves.row(0)), 0);
  EXPECT_EQ(cv::countNonZero(moves.row(1)), 15);
  EXPECT_EQ(moves.at<uchar>(1, 13), 255);
  EXPECT_EQ(moves.at<uchar>(1, 27), 255);
  EXPECT_EQ(cv::countNonZero(moves.row(2)), 8) << "columns outside the image count nothing";
}

TEST(Displacement, NothingMovesBelowTheNoise) {
  EXPECT_TRUE(equal(displacement(plain(5), plain(0), {.noise = 5, .bound_px = 0}), plain(0)));
}

}  // namespace
}  // namespace floorline::golden
