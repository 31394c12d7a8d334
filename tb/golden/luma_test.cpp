#include "golden/luma.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_image.h"

namespace floorline::golden {
namespace {

TEST(Luma, WeighsColoursInOpenCvOrder) {
  const cv::Mat blue(1, 1, CV_8UC3, cv::Scalar(255, 0, 0));
  const cv::Mat green(1, 1, CV_8UC3, cv::Scalar(0, 255, 0));
  const cv::Mat red(1, 1, CV_8UC3, cv::Scalar(0, 0, 255));
  EXPECT_EQ(luma(blue).at<uchar>(0, 0), 29);
  EXPECT_EQ(luma(green).at<uchar>(0, 0), 150);
  EXPECT_EQ(luma(red).at<uchar>(0, 0), 76);
}

TEST(Luma, LiesWithinHalfALevelOfTheExactValue) {
  const cv::Mat image = random_image({64, 48}, CV_8UC3);
  const cv::Mat y = luma(image);
  ASSERT_EQ(y.type(), CV_8UC1);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const cv::Vec3b bgr = image.at<cv::Vec3b>(v, u);
      EXPECT_NEAR(y.at<uchar>(v, u), 0.299 * bgr[2] + 0.587 * bgr[1] + 0.114 * bgr[0], 0.5 + 1e-4);
    }
  }
}

TEST(Luma, PassesGrey) {
  const cv::Mat grey = random_image({33, 17}, CV_8UC1);
  EXPECT_TRUE(equal(luma(grey), grey));
}

}  // namespace
}  // namespace floorline::golden
