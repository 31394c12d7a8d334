/// Frames and parameters drawn at random, from which something comes out.
#ifndef FLOORLINE_TB_COSIM_RANDOM_FRAMES_H
#define FLOORLINE_TB_COSIM_RANDOM_FRAMES_H

#include <opencv2/core.hpp>

#include "tb/cosim/cosimulation.h"

namespace floorline::cosim {

/// What the frames of a scene show.
enum class Scene {
  unrelated,  ///< Shapes over noise, others in every frame; every parameter over the range that a host may
              ///< write.
  floor,     ///< Texture that moves by a few pixels, which the homography knows, with boxes that it does not.
  contacts,  ///< Bars, specks and noise before a black reference: many contacts a line, on all lines.
  splits     ///< Grey levels whose best split is a near tie, or that leave none, before a black reference.
};

/// Draws frames.
class RandomFrames {
 public:
  explicit RandomFrames(std::uint64_t seed) : random_(seed) {}

  /// A scene of frames of one size, seen through one line table.
  void begin_scene(cv::Size size);
  /// The next frame of the scene; the first one becomes the reference.
  FrameInput next();

  /// From 16x16 on.
  cv::Size size(cv::Size largest);
  /// Grey or colour.
  cv::Mat image(cv::Size size);
  FrameParameters parameters(cv::Size size);
  /// A beam through the image or a part of it, or lines that cross it anyhow; none when the image is too
  /// narrow for lines.
  std::vector<LineSetup> lines(cv::Size size);

  int number(int first, int last) { return random_.uniform(first, last + 1); }
  bool chance(double probability) { return random_.uniform(0.0, 1.0) < probability; }

 private:
  std::vector<LineSetup> crossing_lines(cv::Size size, int count);
  ProjectiveMap homography(cv::Size size);
  ProjectiveMap birdseye(cv::Size size);
  FrameInput floor_frame();
  FrameInput contacts_frame();
  FrameInput splits_frame();
  cv::Mat split_image();
  cv::Mat colour_differences(cv::Size size);
  cv::Point point() { return {number(0, size_.width - 1), number(0, size_.height - 1)}; }

  cv::RNG random_;
  Scene scene_ = Scene::unrelated;
  cv::Size size_;
  std::vector<LineSetup> lines_;
  bool first_ = true;  ///< The next frame is the first of its scene.
  cv::Mat texture_;    ///< The floor; a frame shows the part of it from offset_ on.
  cv::Point offset_;
  cv::Point reference_offset_;  ///< offset_ of the frame that is the reference.
};

}  // namespace floorline::cosim

#endif
