/// Frames and parameters drawn at random, from which something comes out: shapes that move over noise.
#ifndef FLOORLINE_TB_COSIM_RANDOM_FRAMES_H
#define FLOORLINE_TB_COSIM_RANDOM_FRAMES_H

#include <opencv2/core.hpp>

#include "tb/cosim/cosimulation.h"

namespace floorline::cosim {

/// Draws frames. Every parameter of the map takes values over the range that a host may write.
class RandomFrames {
 public:
  explicit RandomFrames(std::uint64_t seed) : random_(seed) {}

  /// From 16x16 on.
  cv::Size size(cv::Size largest);
  /// Grey or colour.
  cv::Mat image(cv::Size size);
  FrameParameters parameters(cv::Size size);
  /// Through the image or a part of it; none when the image is too narrow for lines.
  std::vector<LineSetup> lines(cv::Size size);
  FrameInput frame(cv::Size size) { return {image(size), parameters(size), lines(size)}; }

  int number(int first, int last) { return random_.uniform(first, last + 1); }
  bool chance(double probability) { return random_.uniform(0.0, 1.0) < probability; }

 private:
  ProjectiveMap homography(cv::Size size);
  ProjectiveMap birdseye(cv::Size size);

  cv::RNG random_;
};

}  // namespace floorline::cosim

#endif
