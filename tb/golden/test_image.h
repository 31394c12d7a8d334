/// Images for tests, the same on every run.
#ifndef FLOORLINE_TB_GOLDEN_TEST_IMAGE_H
#define FLOORLINE_TB_GOLDEN_TEST_IMAGE_H

#include <algorithm>
#include <initializer_list>
#include <opencv2/core.hpp>

namespace floorline::golden {

inline cv::Mat random_image(cv::Size size, int type, int below = 256, std::uint64_t seed = 1) {
  cv::Mat image(size, type);
  cv::RNG random(seed);
  random.fill(image, cv::RNG::UNIFORM, 0, below);
  return image;
}

/// A mask of 0 and 255 with the given share of set pixels, in percent.
inline cv::Mat random_mask(cv::Size size, int percent, std::uint64_t seed) {
  return random_image(size, CV_8UC1, 100, seed) < percent;
}

inline cv::Mat row_image(std::initializer_list<int> values) {
  cv::Mat image(1, static_cast<int>(values.size()), CV_8UC1);
  std::copy(values.begin(), values.end(), image.begin<uchar>());
  return image;
}

/// Whether two images agree in size, type and every pixel.
inline bool equal(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

}  // namespace floorline::golden

#endif
