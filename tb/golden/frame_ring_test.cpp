#include "golden/frame_ring.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "test_image.h"

namespace floorline::golden {
namespace {

const cv::Size size(40, 30);
constexpr int roomy = 60;  // The whole reference stays alive.

cv::Matx33d shift(double x, double y) { return {1, 0, x, 0, 1, y, 0, 0, 1}; }

TEST(FrameRing, NothingIsValidBeforeAReplacement) {
  FrameRing ring(roomy);
  const cv::Mat frame = random_image(size, CV_8UC1);
  EXPECT_EQ(cv::countNonZero(ring.pair(frame, shift(0, 0), false).valid), 0);
  EXPECT_EQ(cv::countNonZero(ring.pair(frame, shift(0, 0), true).valid), 0);
  EXPECT_EQ(cv::countNonZero(ring.pair(frame, shift(0, 0), false).valid), size.area());
}

TEST(FrameRing, HoldsTheReferenceUntilReplaced) {
  FrameRing ring(roomy);
  const cv::Mat first = random_image(size, CV_8UC1, 256, 1);
  const cv::Mat second = random_image(size, CV_8UC1, 256, 2);
  ring.pair(first, shift(0, 0), true);
  EXPECT_TRUE(equal(ring.pair(second, shift(0, 0), false).reference, first));
  EXPECT_TRUE(equal(ring.pair(second, shift(0, 0), true).reference, first));
  EXPECT_TRUE(equal(ring.pair(first, shift(0, 0), false).reference, second));
}

TEST(FrameRing, AnotherSizeDropsTheReference) {
  FrameRing ring(roomy);
  ring.pair(random_image(size, CV_8UC1), shift(0, 0), true);
  const cv::Mat larger = random_image({50, 30}, CV_8UC1);
  EXPECT_EQ(cv::countNonZero(ring.pair(larger, shift(0, 0), false).valid), 0);
  EXPECT_EQ(cv::countNonZero(ring.pair(random_image(size, CV_8UC1), shift(0, 0), true).valid), 0);
  EXPECT_EQ(cv::countNonZero(ring.pair(random_image(size, CV_8UC1), shift(0, 0), true).valid), size.area());
}

TEST(FrameRing, BordersLieHalfAPixelOutside) {
  FrameRing ring(roomy);
  const cv::Mat reference = random_image(size, CV_8UC1);
  ring.pair(reference, shift(0, 0), true);
  const PixelPairs pairs = ring.pair(reference, shift(0.5, -0.5), false);
  EXPECT_EQ(pairs.valid.at<uchar>(0, 0), 255) << "y = -0.5 belongs to row 0";
  EXPECT_EQ(pairs.valid.at<uchar>(0, size.width - 1), 0) << "x = width - 0.5 lies outside";
}

TEST(FrameRing, ReferenceIsInterpolatedInSteps) {
  FrameRing ring(roomy);
  const cv::Mat reference = random_image(size, CV_8UC1);
  ring.pair(reference, shift(0, 0), true);
  // Rounded to 16/64 and 48/64.
  const PixelPairs pairs = ring.pair(reference, shift(0.257, 0.743), false);
  const int a = reference.at<uchar>(7, 12), b = reference.at<uchar>(7, 13), c = reference.at<uchar>(8, 12),
            d = reference.at<uchar>(8, 13);
  EXPECT_EQ(pairs.reference.at<uchar>(7, 12), (3 * a + b + 9 * c + 3 * d + 8) / 16);
  // In the last column the cell is clamped to one column.
  const int above = reference.at<uchar>(7, size.width - 1), below = reference.at<uchar>(8, size.width - 1);
  EXPECT_EQ(pairs.reference.at<uchar>(7, size.width - 1), (above + 3 * below + 2) / 4);
  EXPECT_EQ(pairs.gradient.at<uchar>(7, size.width - 1), std::abs(above - below));
}

TEST(FrameRing, GradientIsTheGreaterDiagonal) {
  FrameRing ring(roomy);
  cv::Mat slope(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) slope.at<uchar>(v, u) = static_cast<uchar>(3 * u + 2 * v);
  }
  ring.pair(slope, shift(0, 0), true);
  const PixelPairs pairs = ring.pair(slope, shift(0.5, 0.5), false);
  EXPECT_EQ(pairs.gradient.at<uchar>(10, 10), 3 + 2) << "of a plane: both slopes together";
}

TEST(FrameRing, AReplacingFrameLosesRowsBeyondTheMargin) {
  constexpr int margin = 8;
  FrameRing ring(size.height + margin);
  const cv::Mat frame = random_image(size, CV_8UC1);
  ring.pair(frame, shift(0, 0), true);
  const auto valid_rows = [&](double up, bool replace) {
    FrameRing copy = ring;
    return cv::countNonZero(copy.pair(frame, shift(0, -up), replace).valid.col(5));
  };
  EXPECT_EQ(valid_rows(margin - 1, true), size.height - (margin - 1)) << "row v - 7 is still there";
  EXPECT_EQ(valid_rows(margin, true), 0) << "row v - 8 has just been overwritten";
  EXPECT_EQ(valid_rows(margin, false), size.height - margin)
      << "nothing is overwritten while the reference is held";
  EXPECT_EQ(valid_rows(-margin, true), size.height - margin) << "rows below are alive";
}

TEST(FrameRing, UnresolvedDenominatorsAreNotValid) {
  FrameRing ring(roomy);
  const cv::Mat frame = random_image(size, CV_8UC1);
  ring.pair(frame, shift(0, 0), true);
  for (const double z : {-1.0, 0.0, 1.0 / 16, 8.0}) {
    const cv::Matx33d map(z, 0, 0, 0, z, 0, 0, 0, z);
    EXPECT_EQ(cv::countNonZero(ring.pair(frame, map, false).valid), 0) << z;
  }
  for (const double z : {1.0 / 15, 7.9}) {
    const cv::Matx33d map(z, 0, 0, 0, z, 0, 0, 0, z);
    EXPECT_EQ(cv::countNonZero(ring.pair(frame, map, false).valid), size.area()) << z;
  }
}

TEST(FrameRing, AgreesWithWarpPerspective) {
  FrameRing ring(roomy);
  cv::Mat reference;
  cv::GaussianBlur(random_image(size, CV_8UC1), reference, {7, 7}, 2);
  ring.pair(reference, shift(0, 0), true);
  const cv::Matx33d h(1.02, 0.01, -0.8, -0.015, 0.99, 0.6, 2e-4, -3e-4, 1);
  const PixelPairs pairs = ring.pair(reference, h, false);
  cv::Mat expected;
  cv::warpPerspective(reference, expected, h, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  // OpenCV rounds coordinates to 1/32 pixel, the ring to 1/64.
  int compared = 0;
  for (int v = 1; v < size.height - 1; ++v) {
    for (int u = 1; u < size.width - 1; ++u) {
      if (pairs.valid.at<uchar>(v, u) == 0 || pairs.valid.at<uchar>(v - 1, u) == 0) continue;
      EXPECT_NEAR(expected.at<uchar>(v, u), pairs.reference.at<uchar>(v, u), 2);
      ++compared;
    }
  }
  EXPECT_GT(compared, size.area() / 2);
}

}  // namespace
}  // namespace floorline::golden
