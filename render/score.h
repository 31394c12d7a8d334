/// Scores reports (obstacles on the floor) against the ground truth of a rendered sequence; docs/detection.md
/// defines every figure.
#ifndef FLOORLINE_RENDER_SCORE_H
#define FLOORLINE_RENDER_SCORE_H

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "truth.h"

namespace floorline::render {

/// What is asked of an obstacle before missing it counts, and how near a report must lie. Distances from the
/// robot's origin.
struct ScoreRules {
  double least_height_m = 0.10;
  double range_m = 4.0;
  double near_range_m = 3.0;  ///< Range of the position error.
  double least_contact_share = 0.3;
  int least_pixels = 150;
  double tolerance_m = 0.15;
  double tolerance_share =
      0.05;  ///< Tolerance of a report at distance d: the greater of tolerance_m and this share of d.
};

/// Counts over frames; add them up with +=.
struct Score {
  int due = 0;           ///< Obstacles that should be reported.
  int found = 0;         ///< Due obstacles with a report within the tolerance of their contact curve.
  int right = 0;         ///< Reports at the foot of an obstacle or wall.
  int wrong = 0;         ///< Reports at no foot.
  int neutral = 0;       ///< Reports beyond range, or at obstacles too low or too hidden to be due.
  int at_obstacles = 0;  ///< Right reports nearest to an obstacle, not to a wall.
  int duplicates = 0;    ///< Reports beyond the first at one foot (connected contact curve) of an obstacle.
  int marked = 0;        ///< Markings with a wrong report on them or within 5 cm.
  int markings = 0;      ///< Markings with their middle ahead of the robot and within range.
  std::vector<double>
      errors_m;  ///< Distance of right reports nearer than near_range_m from their contact curve.

  double recall() const;
  double precision() const;
  double duplicate_share() const;  ///< Of the reports at obstacles.
  double marking_share() const;    ///< Markings reported, of all markings.
  double median_error_m() const;
  Score& operator+=(const Score& other);
};

/// Scores the reports of one frame (robot frame, metres).
Score score_reports(const std::vector<Eigen::Vector2d>& reports, const TrueFrame& truth,
                    const ScoreRules& rules);

/// Pixels: how the mask of differences agrees with what stands above the floor.
struct PixelScore {
  long hit = 0, false_alarm = 0, missed = 0;
  double precision() const;
  double recall() const;
  PixelScore& operator+=(const PixelScore& other);
};

/// Compares a mask (non-zero: obstacle) with a truth mask of the same size on rows >= first_row; unknown
/// pixels do not count.
PixelScore score_pixels(const cv::Mat& mask, const cv::Mat& truth_mask, int first_row);

}  // namespace floorline::render

#endif
