/// From calibration, odometry and settings to the parameters of every frame, floating-point and fixed-point.
#ifndef FLOORLINE_HOST_PARAMETERS_H
#define FLOORLINE_HOST_PARAMETERS_H

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "golden/lens.h"
#include "golden/parameters.h"
#include "hls/parameters.h"
#include "hls/types.h"
#include "host/camera.h"
#include "host/reference_plan.h"

namespace floorline {

/// What a user chooses.
struct Settings {
  golden::Thresholds threshold = {};
  golden::Rule rule = golden::Rule::run;
  int min_rows = 12;             ///< Least rows of a run.
  int max_gap = 2;               ///< Rows without a low pixel that a run survives.
  double least_height_m = 0.08;  ///< Runs shorter than an obstacle of this height would be are dropped.
  bool erode = false;            ///< Erosion of the high mask.
  int line_count = 256;
  int roi_margin_rows = 20;    ///< Rows between the horizon and the first one that is looked at.
  double cluster_gap_m = 0.5;  ///< What lies so near to a nearer point, in x and y, is on its obstacle.
  int min_lines = 2;           ///< Least lines of an obstacle.
  int noise = 2;  ///< Grey levels that difference and gradient owe to the sensor; 255: motion unknown.
  double still_px = 0.8;  ///< What a foot may seem to have moved, for noise and odometry...
  double still_rows = 3;  ///< ...and as much more as an obstacle moves so many rows above its foot.
  ReferenceRule reference = {};
};

/// The settings of the ICVS paper: its rule on 120 lines, erosion, Otsu's threshold alone, difference of
/// successive frames, each line its own report.
Settings paper_settings();

/// The lens that rectifies the frames of a camera, bilinear; none for a camera without distortion.
std::optional<golden::Lens> rectification(const Camera& camera);

/// What a camera on a robot keeps from frame to frame.
class Configuration {
 public:
  /// Throws Error when no floor is in view, the camera is larger than every build of the accelerator, or the
  /// lines cannot keep up.
  Configuration(const Camera& camera, const Eigen::Isometry3d& robot_from_camera, const Settings& settings);

  ReferencePlan reference_plan() const;
  golden::Parameters golden_parameters(const PlannedFrame& frame) const;

  /// Throws Error when a matrix cannot be packed within its error bound. `grey` as in FrameParameters.
  FrameParameters frame_parameters(const PlannedFrame& frame, bool grey) const;

  /// Pixels that a point one row above its foot moves against the floor, per pixel of its distance from the
  /// epipole, with the robot moved by baseline_m: kappa of docs/detection.md.
  double parallax_share(double baseline_m) const;

  const std::vector<LineSetup>& lines() const { return lines_; }
  cv::Rect roi() const { return roi_; }  ///< All columns; rows from below the horizon to the last.
  int ring_rows() const { return ring_rows_; }

  /// Rectification of this camera's frames; the parameters are for rectified frames.
  std::optional<golden::Lens> lens() const { return rectification(camera_); }

 private:
  golden::DisplacementParameters displacement(const PlannedFrame& frame) const;

  Camera camera_;
  Eigen::Isometry3d robot_from_camera_;
  ReferenceRule reference_rule_;
  cv::Rect roi_;
  int ring_rows_;
  std::vector<LineSetup> lines_;
  golden::Parameters base_;  ///< All but what a frame's homography, baseline and reference bit give.
  double still_px_;
  double still_rows_;
};

}  // namespace floorline

#endif
