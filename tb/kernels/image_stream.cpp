#include "image_stream.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

namespace floorline {
namespace {

const cv::Size kVga(640, 480);

cv::Mat ramp(cv::Size size) {
  cv::Mat image(size, CV_8UC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) image.at<uchar>(v, u) = static_cast<uchar>(3 * u + 5 * v);
  }
  return image;
}

/// Mostly dark with a bright tail, like a difference image.
cv::Mat skewed(cv::Size size, int seed) {
  cv::Mat image;
  const cv::Mat uniform = noise(size, seed);
  uniform.convertTo(image, CV_32F, 1 / 255.0);
  cv::pow(image, 6, image);
  image.convertTo(image, CV_8U, 255);
  return image;
}

}  // namespace

cv::Mat packed(const golden::Masks& masks) { return (masks.high & 2) | (masks.low & 1); }

int greatest_difference(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size()) return 256;
  return static_cast<int>(cv::norm(a, b, cv::NORM_INF));
}

void expect_figure(const std::string& name, double value, double bound) {
  std::ostringstream text;
  text << value << ' ' << bound;
  testing::Test::RecordProperty(name, text.str());
  EXPECT_LE(value, bound) << name;
}

cv::Mat noise(cv::Size size, int seed) {
  cv::Mat image(size, CV_8UC1);
  cv::RNG(seed).fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

std::vector<NamedImage> synthetic_images() {
  std::vector<NamedImage> images;
  const std::vector<cv::Size> sizes = {{1, 1}, {2, 2},  {3, 3},   {1, 9},    {9, 1}, {2, 7},
                                       {7, 2}, {17, 5}, {16, 16}, {101, 37}, kVga};
  for (const cv::Size size : sizes) {
    const std::string name = std::to_string(size.width) + "x" + std::to_string(size.height);
    images.push_back({"noise " + name, noise(size, 1 + size.area())});
    images.push_back({"ramp " + name, ramp(size)});
  }
  const cv::Size size(64, 48);
  images.push_back({"bilevel", noise(size, 2) > 200});
  images.push_back({"checkerboard", (ramp(size) & 1) * 255});
  images.push_back({"skewed", skewed(kVga, 3)});
  for (const int level : {0, 1, 128, 255}) {
    images.push_back({"constant " + std::to_string(level), cv::Mat(size, CV_8UC1, cv::Scalar(level))});
  }
  return images;
}

std::vector<NamedImage> real_images() {
  namespace fs = std::filesystem;
  const fs::path data = fs::path(FLOORLINE_SOURCE_DIR).parent_path() / "shared" / "data";
  std::vector<fs::path> files;
  for (const char* folder : {"unit_opencv", "unit_skimage"}) {
    if (!fs::exists(data / folder)) continue;
    for (const auto& entry : fs::directory_iterator(data / folder)) files.push_back(entry.path());
  }
  for (const char* folder : {"kitti_odo06", "kitti_trk0003a"}) {
    for (const char* frame : {"000000.png", "000005.png"}) files.push_back(data / folder / "image_0" / frame);
  }
  std::sort(files.begin(), files.end());

  std::vector<NamedImage> images;
  for (const fs::path& file : files) {
    if (file.extension() != ".png" && file.extension() != ".jpg") continue;
    const cv::Mat image = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (image.empty()) continue;
    const cv::Rect cut(0, 0, std::min(image.cols, kVga.width), std::min(image.rows, kVga.height));
    images.push_back({file.filename().string(), image(cut).clone()});
  }
  return images;
}

}  // namespace floorline
