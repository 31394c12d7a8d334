/// The whole golden pipeline: image in, every stage and the obstacles out.
#ifndef FLOORLINE_GOLDEN_PIPELINE_H
#define FLOORLINE_GOLDEN_PIPELINE_H

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "golden/birdseye.h"
#include "golden/cluster.h"
#include "golden/frame_ring.h"
#include "golden/lens.h"
#include "golden/parameters.h"
#include "golden/polar.h"

namespace floorline::golden {

/// What every stage gave for one frame.
struct Stages {
  cv::Mat luma;  ///< CV_8UC1; rectified when the pipeline has a lens.
  PixelPairs pairs;
  cv::Mat difference;  ///< CV_8UC1.
  cv::Mat motion;      ///< CV_8UC1, of each pixel against the floor (displacement.h).
  cv::Mat blurred;     ///< CV_8UC1.
  int otsu_threshold;  ///< Of this frame; the next one uses it.
  int high_threshold;  ///< Used for this frame.
  Masks binary;
  Masks eroded;  ///< The same as `binary` without erosion.
  Masks region;  ///< Within the rows of interest.
  PolarHistogram histogram;
  std::vector<FloorPoint> points;
  std::vector<Obstacle> obstacles;
};

/// Architecture 2 in floating point. State from frame to frame: the reference in its ring and Otsu's
/// threshold (0 before the first frame).
class Pipeline {
 public:
  /// ring_rows: rows of the frame ring, at least the height of every frame. lens: rectifies the frames first.
  explicit Pipeline(int ring_rows, std::optional<Lens> lens = std::nullopt);

  /// image: CV_8UC1 or CV_8UC3 (B G R).
  Stages process(const cv::Mat& image, const Parameters& parameters);

 private:
  FrameRing ring_;
  std::optional<Lens> lens_;
  int otsu_threshold_ = 0;
};

}  // namespace floorline::golden

#endif
