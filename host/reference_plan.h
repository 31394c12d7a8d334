/// Which frame is the reference: the baseline is the signal, so a reference is held until the robot has moved
/// far enough.
#ifndef FLOORLINE_HOST_REFERENCE_PLAN_H
#define FLOORLINE_HOST_REFERENCE_PLAN_H

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "host/camera.h"

namespace floorline {

/// When a reference has done its duty.
struct ReferenceRule {
  int every = 0;             ///< After so many frames; 0: when the parallax below is reached.
  double parallax_px = 0.8;  ///< Of a point at...
  double distance_m = 2.5;   ///< ...this distance ahead of the robot's origin...
  double height_m = 0.1;     ///< ...and this height above the floor.
};

/// What to do with one frame.
struct PlannedFrame {
  int reference = -1;   ///< Frame that the pair is made with; -1: none yet.
  bool replace = true;  ///< This frame becomes the reference.
  Eigen::Matrix3d homography =
      Eigen::Matrix3d::Identity();  ///< Current pixel -> reference pixel, 1 in the middle of the ROI.
  double parallax_px = 0;           ///< Of the pair.
  double baseline_m = 0;            ///< Distance that the robot moved from one to the other.
  bool mature =
      false;  ///< The baseline is as long as wanted and no row of the ROI is lost: worth detecting in.
};

/// Plans frame after frame. A frame whose pair is mature becomes the reference, when the ring can hold it: a
/// replacing frame overwrites rows of the reference that lie more than the ring's margin above. Where the
/// floor has moved further down than that, the plan is split: the mature frame detects while the reference is
/// held, the frame after it only replaces the reference.
class ReferencePlan {
 public:
  /// roi: columns and rows in which floor is looked at; margin_rows: rows of the ring beyond the frame's.
  ReferencePlan(const Camera& camera, const Eigen::Isometry3d& robot_from_camera, const ReferenceRule& rule,
                cv::Rect roi, int margin_rows);

  /// The next frame, taken with the robot at world_from_robot. Throws Error when the pose is not finite.
  PlannedFrame next(const Eigen::Isometry3d& world_from_robot);

 private:
  double parallax_px(const Eigen::Matrix3d& homography,
                     const Eigen::Isometry3d& reference_from_current) const;
  bool fits_ring(const Eigen::Matrix3d& homography) const;

  Camera camera_;
  Eigen::Isometry3d robot_from_camera_;
  ReferenceRule rule_;
  cv::Rect roi_;
  int margin_rows_;
  int frame_ = 0;
  int reference_ = -1;
  bool replace_next_ = false;
  Eigen::Isometry3d world_from_reference_;
};

}  // namespace floorline

#endif
