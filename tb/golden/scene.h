/// A synthetic view for tests of the whole pipeline: textured floor that moves by a known shift, and one
/// obstacle that does not move with it.
#ifndef FLOORLINE_TB_GOLDEN_SCENE_H
#define FLOORLINE_TB_GOLDEN_SCENE_H

#include <opencv2/imgproc.hpp>

#include "golden/parameters.h"
#include "test_image.h"

namespace floorline::golden {

constexpr int shift_rows = 6;  ///< The floor moves down so far from frame to frame.

inline cv::Mat view(cv::Size size, int frame, cv::Rect obstacle) {
  cv::Mat texture;
  cv::GaussianBlur(random_image({size.width, 2 * size.height}, CV_8UC1, 256, 5), texture, {0, 0}, 3);
  cv::normalize(texture, texture, 60, 180, cv::NORM_MINMAX);
  const int top = size.height - frame * shift_rows;
  cv::Mat image = texture(cv::Rect(0, top, size.width, size.height)).clone();
  // Stripes whose motion differs from the floor's: they stay where they are.
  for (int u = obstacle.x; u < obstacle.br().x; ++u) {
    for (int v = obstacle.y; v < obstacle.br().y; ++v) image.at<uchar>(v, u) = v / shift_rows % 2 ? 255 : 0;
  }
  return image;
}

inline Parameters parameters_of(cv::Size size) {
  Parameters parameters;
  parameters.homography = {1, 0, 0, 0, 1, -shift_rows, 0, 0, 1};
  parameters.birdseye = {0, -0.01, size.height * 0.01, -0.01, 0, size.width * 0.005, 0, 0, 1};
  parameters.roi_last_row = size.height - 1;
  parameters.threshold = {.floor = 20, .override_high = 30, .low = 11};
  parameters.cluster_gap_m = 0.75;
  for (int i = 0; i < 60; ++i) {
    const int u = i * size.width / 60;
    parameters.lines.push_back({{u, 0}, {u, size.height - 1}});
  }
  return parameters;
}

}  // namespace floorline::golden

#endif
