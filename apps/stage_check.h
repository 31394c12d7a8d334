/// Each kernel against its golden twin on the same input: what `check` measures and what the report shows.
#ifndef FLOORLINE_APPS_STAGE_CHECK_H
#define FLOORLINE_APPS_STAGE_CHECK_H

#include <array>
#include <string_view>
#include <vector>

#include "golden/frame_ring.h"
#include "golden/parameters.h"
#include "golden/pipeline.h"
#include "report/document.h"
#include "tb/csim/csim.h"

namespace floorline::app {

/// The image stages, in pipeline order.
enum class ImageStage { luma, frame_ring, difference, displacement, gaussian, binarize, erode, roi };
constexpr int kImageStages = 8;

/// How far a kernel is from its twin over all frames so far, in the unit of its bound.
struct StageBound {
  std::string_view name;     ///< Kernel name.
  std::string_view measure;  ///< For people: what is bounded.
  std::string_view unit;
  double bound;
};

/// Kernel and twin of one image stage in one frame. Images CV_8UC1; masks hold 0 to 3.
struct StagePair {
  cv::Mat kernel;
  cv::Mat golden;
  double worst = 0;  ///< In the unit of the stage's bound.
};

using StagePairs = std::array<StagePair, kImageStages>;

/// Feeds every golden stage with what its kernel was fed, and keeps the greatest deviation of each stage.
class StageCheck {
 public:
  /// ring_rows: rows of the kernel's frame ring.
  explicit StageCheck(int ring_rows);

  /// One frame, in order: the image that went in, the parameters in natural units, and what the kernels made
  /// of it.
  StagePairs add(const cv::Mat& image, const golden::Parameters& parameters, const StageCapture& capture,
                 const FrameOutput& output);

  /// One a stage, against the bounds of docs/architecture.md's formats.
  std::vector<report::Figure> figures() const;

 private:
  void check_results(const golden::Parameters& parameters, const StageCapture& capture,
                     const FrameOutput& output);

  golden::FrameRing ring_;
  cv::Mat reference_;
  int ring_rows_;
  int otsu_before_ = 0;
  std::vector<double> worst_;  ///< In the order of the bounds in stage_check.cpp.
};

/// The bounds of the image stages first, in the order of ImageStage, then those of otsu, polar, birdseye and
/// cluster.
const std::vector<StageBound>& stage_bounds();

}  // namespace floorline::app

#endif
