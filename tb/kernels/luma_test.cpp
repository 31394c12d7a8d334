#include "hls/luma.h"

#include <opencv2/imgproc.hpp>

#include "golden/luma.h"
#include "image_stream.h"

namespace floorline {
namespace {

/// Three channels of noise or colour in OpenCV's order through the kernel.
cv::Mat run(const cv::Mat& bgr, bool grey) {
  hls::stream<RgbPixel> in("rgb");
  hls::stream<Pixel> out("luma");
  for (int v = 0; v < bgr.rows; ++v) {
    for (int u = 0; u < bgr.cols; ++u) {
      const cv::Vec3b pixel = bgr.at<cv::Vec3b>(v, u);
      in.write(RgbPixel(pixel[2] << 16 | pixel[0] << 8 | pixel[1]));
    }
  }
  luma<640, 480>(in, out, bgr.cols, bgr.rows, grey);
  EXPECT_TRUE(in.empty());
  return receive(bgr.size(), out);
}

cv::Mat colour_noise(cv::Size size, int seed) {
  cv::Mat image;
  cv::merge(std::vector<cv::Mat>{noise(size, seed), noise(size, seed + 1), noise(size, seed + 2)}, image);
  return image;
}

TEST(Luma, IsWithinOneOfGolden) {
  int worst = 0;
  for (const cv::Size size : {cv::Size(1, 1), {17, 5}, {640, 480}}) {
    const cv::Mat image = colour_noise(size, 7);
    worst = std::max(worst, greatest_difference(run(image, false), golden::luma(image)));
  }
  expect_figure("luma_error_lsb", worst, 1);
}

TEST(Luma, KeepsEveryGreyLevelExactly) {
  cv::Mat levels(1, 256, CV_8UC1);
  for (int i = 0; i < 256; ++i) levels.at<uchar>(i) = static_cast<uchar>(i);
  cv::Mat colour;
  cv::cvtColor(levels, colour, cv::COLOR_GRAY2BGR);
  EXPECT_EQ(greatest_difference(run(colour, false), levels), 0);
}

TEST(Luma, WhiteAndPrimariesAreNotBeyondTheRange) {
  const cv::Mat corners = (cv::Mat_<cv::Vec3b>(1, 4) << cv::Vec3b(255, 255, 255), cv::Vec3b(255, 0, 0),
                           cv::Vec3b(0, 255, 0), cv::Vec3b(0, 0, 255));
  const cv::Mat expected = (cv::Mat_<uchar>(1, 4) << 255, 29, 150, 76);
  EXPECT_EQ(greatest_difference(run(corners, false), expected), 0);
}

TEST(Luma, GreyPassesTheLowByte) {
  const cv::Mat image = colour_noise({33, 9}, 1);
  cv::Mat green;
  cv::extractChannel(image, green, 1);
  EXPECT_EQ(greatest_difference(run(image, true), green), 0);
}

}  // namespace
}  // namespace floorline
