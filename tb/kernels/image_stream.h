/// Frames in and out of the kernels' streams, and the frames that every kernel is tried on.
#ifndef FLOORLINE_TB_KERNELS_IMAGE_STREAM_H
#define FLOORLINE_TB_KERNELS_IMAGE_STREAM_H

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "golden/binarize.h"
#include "hls/types.h"
#include "hls_stream.h"

namespace floorline {

/// Writes a CV_8UC1 image pixel by pixel, row by row.
template <typename Element>
void send(const cv::Mat& image, hls::stream<Element>& stream) {
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) stream.write(Element(image.at<uchar>(v, u)));
  }
}

/// Reads an image of `size` and expects that the stream holds nothing more.
template <typename Element>
cv::Mat receive(cv::Size size, hls::stream<Element>& stream) {
  cv::Mat image(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) image.at<uchar>(v, u) = static_cast<uchar>(stream.read().to_int());
  }
  EXPECT_TRUE(stream.empty()) << "more than width * height elements came out";
  return image;
}

/// Masks as the kernels carry them: 2 * high + low a pixel.
cv::Mat packed(const golden::Masks& masks);

/// Largest difference of two images of one size; a difference of size counts as 256.
int greatest_difference(const cv::Mat& a, const cv::Mat& b);

/// Uniform noise, the same for the same seed.
cv::Mat noise(cv::Size size, int seed);

/// Images of one size and kind each, all within 640 x 480: tiny ones, odd ones, full VGA, noise, ramps,
/// bilevel and constant images.
struct NamedImage {
  std::string name;
  cv::Mat image;
};
std::vector<NamedImage> synthetic_images();

/// Grey images of ../shared/data within 640 x 480 (larger ones are cut): empty where that folder is absent.
std::vector<NamedImage> real_images();

/// A figure of scripts/figures/kernels.sh: `value` must not exceed `bound`. Expects that it does not.
void expect_figure(const std::string& name, double value, double bound);

/// Skips the test that calls it when there are no real images.
#define FLOORLINE_REAL_IMAGES_OR_SKIP(images)           \
  const std::vector<NamedImage> images = real_images(); \
  if (images.empty()) GTEST_SKIP() << "no images in ../shared/data"

}  // namespace floorline

#endif
