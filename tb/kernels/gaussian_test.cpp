#include "hls/gaussian.h"

#include "golden/gaussian.h"
#include "image_stream.h"

namespace floorline {
namespace {

cv::Mat run(const cv::Mat& image) {
  hls::stream<Pixel> in("pixels");
  hls::stream<Pixel> out("blurred");
  send(image, in);
  gaussian<640, 480>(in, out, image.cols, image.rows);
  EXPECT_TRUE(in.empty());
  return receive(image.size(), out);
}

/// Greatest difference from golden over all images.
int worst_difference(const std::vector<NamedImage>& images) {
  int worst = 0;
  for (const auto& [name, image] : images) {
    const int difference = greatest_difference(run(image), golden::gaussian(image));
    EXPECT_LE(difference, 1) << name;
    worst = std::max(worst, difference);
  }
  return worst;
}

TEST(Gaussian, IsWithinOneOfGoldenOnSyntheticImages) {
  expect_figure("gaussian_error_lsb", worst_difference(synthetic_images()), 1);
}

TEST(Gaussian, IsWithinOneOfGoldenOnRealImages) {
  FLOORLINE_REAL_IMAGES_OR_SKIP(images);
  expect_figure("gaussian_error_lsb_real", worst_difference(images), 1);
}

TEST(Gaussian, KeepsAConstantImage) {
  for (const int level : {0, 1, 254, 255}) {
    const cv::Mat image(5, 7, CV_8UC1, cv::Scalar(level));
    EXPECT_EQ(greatest_difference(run(image), image), 0) << level;
  }
}

TEST(Gaussian, SpreadsAnImpulseByItsWeights) {
  cv::Mat impulse = cv::Mat::zeros(5, 5, CV_8UC1);
  impulse.at<uchar>(2, 2) = 255;
  const cv::Mat spread = run(impulse);
  EXPECT_NEAR(spread.at<uchar>(2, 2), 255 * 0.5220 * 0.5220, 1);
  EXPECT_NEAR(spread.at<uchar>(2, 1), 255 * 0.5220 * 0.2390, 1);
  EXPECT_NEAR(spread.at<uchar>(1, 1), 255 * 0.2390 * 0.2390, 1);
  EXPECT_EQ(spread.at<uchar>(0, 0), 0);
}

TEST(Gaussian, AFrameLeavesNothingForTheNext) {
  run(noise({640, 480}, 1));
  const cv::Mat image = noise({31, 20}, 2);
  EXPECT_LE(greatest_difference(run(image), golden::gaussian(image)), 1);
}

}  // namespace
}  // namespace floorline
