/// Parameters of the golden pipeline in natural units; the fixed-point ones are in hls/parameters.h.
#ifndef FLOORLINE_GOLDEN_PARAMETERS_H
#define FLOORLINE_GOLDEN_PARAMETERS_H

#include <opencv2/core.hpp>
#include <vector>

namespace floorline::golden {

/// Whether the accelerator divides by the denominator Z of a projective map: 2^-4 < Z < 8. Maps are scaled so
/// that Z = 1 in the middle of the rows of interest.
inline bool denominator_resolved(double z) { return z > 1.0 / 16 && z < 8; }

/// Grey levels.
struct Thresholds {
  int floor = 20;         ///< The high threshold is never below this.
  int override_high = 7;  ///< 0: Otsu's of the frame before; else this value.
  int low = 3;
};

/// How far a pixel must have moved against the floor (displacement.h).
struct DisplacementParameters {
  int noise = 255;  ///< Grey levels that difference and gradient owe to the sensor; 255: no motion is known.
  double bound_px = 0;       ///< What a still pixel may have moved in row 0...
  double bound_step_px = 0;  ///< ...and more of it a row further down.
};

/// How a run along a line becomes a contact point (docs/architecture.md, Rules).
enum class Rule { paper, run };

struct RuleParameters {
  Rule kind = Rule::run;
  int min_rows = 12;        ///< Least rows of a run.
  int max_gap = 2;          ///< Rows without a low pixel that a run survives.
  double horizon_row = 0;   ///< Row of the horizon at the image centre.
  double height_ratio = 0;  ///< Least obstacle height over camera height; 0: no least height.
};

/// A line of the polar histogram by its end points, walked from `first` (the upper one) to `last`. Rows from
/// 0 on; columns may lie outside the image.
struct Line {
  cv::Point first;
  cv::Point last;
  bool contact_first =
      false;  ///< The contact is the first row of a run: the line is walked away from the nadir.
};

struct Parameters {
  bool replace_reference = true;  ///< This frame becomes the reference of the next ones.
  bool erode_high = false;
  int roi_first_row = 0;
  int roi_last_row = 0;  ///< Inclusive.
  cv::Matx33d homography =
      cv::Matx33d::eye();                     ///< Current pixel -> reference pixel, Z near 1 over the frame.
  cv::Matx33d birdseye = cv::Matx33d::eye();  ///< Pixel -> floor metres, robot frame.
  Thresholds threshold;
  DisplacementParameters displacement;
  RuleParameters rule;
  std::vector<Line> lines;
  double cluster_gap_m = 0.25;  ///< What lies so near to a nearer point, in x and y, is on its obstacle.
  int min_lines = 2;            ///< Least lines of an obstacle: lone lines are mostly noise.
};

}  // namespace floorline::golden

#endif
