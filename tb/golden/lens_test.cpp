#include "golden/lens.h"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "test_image.h"

namespace floorline::golden {
namespace {

const cv::Size size(160, 120);
const cv::Matx33d camera(130, 0, 79.5, 0, 131, 59.5, 0, 0, 1);
const std::array<double, 5> barrel = {-0.28, 0.09, 0.0011, -0.0007, -0.012};

TEST(Lens, WithoutDistortionChangesNothing) {
  const cv::Mat image = random_image(size, CV_8UC1);
  for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::bilinear}) {
    EXPECT_TRUE(equal(Lens(camera, {}, size, interpolation).rectify(image), image));
  }
}

TEST(Lens, SourceAgreesWithOpenCvsMap) {
  const Lens lens(camera, barrel, size, Interpolation::nearest);
  cv::Mat x, y;
  cv::initUndistortRectifyMap(camera, cv::Mat(1, 5, CV_64F, const_cast<double*>(barrel.data())),
                              cv::noArray(), camera, size, CV_32FC1, x, y);
  for (int v = 0; v < size.height; v += 7) {
    for (int u = 0; u < size.width; u += 7) {
      EXPECT_NEAR(lens.source(u, v).x, x.at<float>(v, u), 1e-4);
      EXPECT_NEAR(lens.source(u, v).y, y.at<float>(v, u), 1e-4);
    }
  }
}

TEST(Lens, BilinearAgreesWithOpenCvsRemap) {
  cv::Mat image;
  cv::GaussianBlur(random_image(size, CV_8UC1), image, {9, 9}, 2);
  cv::Mat expected, x, y;
  cv::initUndistortRectifyMap(camera, cv::Mat(1, 5, CV_64F, const_cast<double*>(barrel.data())),
                              cv::noArray(), camera, size, CV_32FC1, x, y);
  cv::remap(image, expected, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  const cv::Mat rectified = Lens(camera, barrel, size, Interpolation::bilinear).rectify(image);
  // OpenCV interpolates at 1/32 of a pixel.
  EXPECT_LE(cv::norm(rectified, expected, cv::NORM_INF), 3);
}

TEST(Lens, ReadsBlackOutsideTheImage) {
  const std::array<double, 5> cushion = {0.4, 0, 0, 0, 0};
  const cv::Mat white(size, CV_8UC1, cv::Scalar(255));
  const cv::Mat rectified = Lens(camera, cushion, size, Interpolation::nearest).rectify(white);
  EXPECT_EQ(rectified.at<uchar>(0, 0), 0);
  EXPECT_EQ(rectified.at<uchar>(60, 80), 255);
}

TEST(Lens, RingRadiusCoversEveryRowThatIsRead) {
  const Lens lens(camera, barrel, size, Interpolation::bilinear);
  double farthest = 0;
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) farthest = std::max(farthest, std::abs(lens.source(u, v).y - v));
  }
  EXPECT_GT(farthest, 3);
  EXPECT_GE(lens.ring_radius(), farthest);
  EXPECT_LE(lens.ring_radius(), farthest + 1);
}

}  // namespace
}  // namespace floorline::golden
