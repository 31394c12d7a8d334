/// A model's findings against the ground truth of a sequence; render/score.h defines the counts.
#ifndef FLOORLINE_APPS_SCORE_H
#define FLOORLINE_APPS_SCORE_H

#include <vector>

#include "drive.h"
#include "model.h"
#include "render/score.h"
#include "report/figure.h"

namespace floorline::app {

/// Contact points against a truth mask that knows no contact curves (KITTI). A contact point is right when it
/// lies within 3 px of the foot of an obstacle's pixels, or in the unknown band below them.
struct MaskScore {
  long right = 0;
  long wrong = 0;  ///< Points whose surroundings are unknown count in neither.
  double precision() const;
  MaskScore& operator+=(const MaskScore& other);
};

/// Sums over frames and sequences. Only frames with a mature baseline count; the grid takes in all.
struct DetectionScore {
  int frames = 0;
  render::Score per_frame;  ///< Each frame's obstacles by themselves.
  render::Score confirmed;  ///< Obstacles that the grid has confirmed and that are in view; from a sequence's
                            ///< second such frame on.
  render::PixelScore pixels;  ///< High mask in the region of interest.
  MaskScore mask;
  bool has_contacts = false;  ///< Some sequence has contact curves: per_frame and confirmed mean something.

  DetectionScore& operator+=(const DetectionScore& other);
};

/// Runs a model to the end of the drive. Throws Error when the sequence has no ground truth.
DetectionScore score(Drive& drive, Model& model, const std::string& task);

/// The figures with the bounds of docs/figures.md: of `per_frame` ("frame.") and `confirmed` ("confirmed.");
/// none without contacts.
std::vector<report::Figure> score_figures(const DetectionScore& score);

}  // namespace floorline::app

#endif
