/// Golden model against C simulation over a sequence: the figures of `check`, and every frame for the report.
#ifndef FLOORLINE_APPS_CHECK_H
#define FLOORLINE_APPS_CHECK_H

#include <functional>
#include <vector>

#include "drive.h"
#include "model.h"
#include "stage_check.h"

namespace floorline::app {

/// What both models made of one frame.
struct CheckedFrame {
  const DriveFrame& input;
  const StagePairs& stages;
  const Finding& kernel;
  const Finding& golden;
  int high_threshold;
  int null_pixels;
};

struct CheckResult {
  std::vector<report::Figure> figures;    ///< One a stage, and the whole pipeline's.
  std::vector<double> contact_distances;  ///< Of paired contact points, pixels.
  long contacts = 0;                      ///< Of both models.

  bool ok() const;
};

/// Runs the drive to its end, both models in step. `look` sees every frame.
CheckResult check(Drive& drive, const std::function<void(const CheckedFrame&)>& look);

}  // namespace floorline::app

#endif
