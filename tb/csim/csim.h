/// C simulation of the accelerator: the very kernels, on cv::Mat frames.
#ifndef FLOORLINE_TB_CSIM_H
#define FLOORLINE_TB_CSIM_H

#include <opencv2/core.hpp>
#include <vector>

#include "hls/parameters.h"
#include "hls/types.h"

namespace floorline {

/// What the accelerator sends for one frame, without the `end` elements.
struct FrameOutput {
  std::vector<FloorPoint> points;
  std::vector<Obstacle> obstacles;
  std::vector<LineCount> counts;  ///< One a line.
  int null_pixels;                ///< Pixels without a counterpart in the reference.
  int threshold_used;             ///< Its high threshold.
};

/// What runs between the stages for one frame. Images CV_8UC1; masks hold 0 to 3 (bit 1 high, bit 0 low).
struct StageCapture {
  cv::Mat luma;
  cv::Mat reference, gradient, valid;  ///< The reference as the homography finds it; valid 0 or 1.
  cv::Mat difference;
  cv::Mat motion;  ///< RESTS, STIRS, UNKNOWN or MOVES.
  cv::Mat blurred;
  int otsu_threshold;  ///< Otsu's threshold that this frame was offered: found on the frame before.
  cv::Mat binary, eroded, region;
  std::vector<Contact> contacts;  ///< Without the `end` element.
};

/// Motions as the grey levels of golden::displacement().
cv::Mat motion_grey(const cv::Mat& motions);

/// The accelerator's state lives in its kernels, as in hardware: one per process. Constructing a CSimulation
/// brings it to the state after reset (no reference, no threshold); of two objects alive, the younger one is
/// right.
class CSimulation {
 public:
  /// Takes the smallest configuration that holds frames of this size: 640x480 or 1280x384. Throws Error when
  /// none does.
  explicit CSimulation(cv::Size largest_frame);

  /// Runs one frame. image: CV_8UC1 (grey) or CV_8UC3 (OpenCV's order, B G R). Width, height, grey and
  /// line_count of `parameters` are set from the arguments. `capture`, if given, receives what runs between
  /// the stages. Throws Error for an image of another type or beyond the configuration, or too many lines.
  FrameOutput run(const cv::Mat& image, FrameParameters parameters, const std::vector<LineSetup>& lines,
                  StageCapture* capture = nullptr);

 private:
  using Frame = FrameOutput(const cv::Mat&, const FrameParameters&, std::vector<LineSetup>, StageCapture*);
  cv::Size maximum_;
  std::size_t most_lines_;
  Frame* frame_;
};

}  // namespace floorline

#endif
