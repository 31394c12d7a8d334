#include "golden/otsu.h"

#include <array>
#include <opencv2/imgproc.hpp>

namespace floorline::golden {
namespace {

std::array<bool, 256> levels_of(const cv::Mat& image) {
  std::array<bool, 256> occurs{};
  for (int v = 0; v < image.rows; ++v) {
    const uchar* row = image.ptr(v);
    for (int u = 0; u < image.cols; ++u) occurs[row[u]] = true;
  }
  return occurs;
}

}  // namespace

int otsu(const cv::Mat& image) {
  cv::Mat unused;
  int threshold = static_cast<int>(cv::threshold(image, unused, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU));
  // A level that does not occur does not move the cut.
  const std::array<bool, 256> occurs = levels_of(image);
  while (threshold > 0 && !occurs[threshold]) --threshold;
  return threshold;
}

}  // namespace floorline::golden
