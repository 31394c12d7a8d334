#include "host/reference_plan.h"

#include <cmath>

#include "host/geometry.h"

namespace floorline {
namespace {

/// Columns and rows at which the displacement is looked at; it is smooth.
constexpr int samples = 9;

}  // namespace

ReferencePlan::ReferencePlan(const Camera& camera, const Eigen::Isometry3d& robot_from_camera,
                             const ReferenceRule& rule, cv::Rect roi, int margin_rows)
    : camera_(camera),
      robot_from_camera_(robot_from_camera),
      rule_(rule),
      roi_(roi),
      margin_rows_(margin_rows) {}

PlannedFrame ReferencePlan::next(const Eigen::Isometry3d& world_from_robot) {
  PlannedFrame plan;
  plan.reference = reference_;
  if (reference_ >= 0) {
    const Eigen::Isometry3d reference_from_current = world_from_reference_.inverse() * world_from_robot;
    const Eigen::Vector2d middle(roi_.x + (roi_.width - 1) / 2.0, roi_.y + (roi_.height - 1) / 2.0);
    plan.homography =
        scaled_at(ground_homography(camera_.matrix, robot_from_camera_, reference_from_current), middle);
    plan.baseline_m = reference_from_current.translation().norm();
    plan.parallax_px = parallax_px(plan.homography, reference_from_current);
    const bool far_enough =
        rule_.every > 0 ? frame_ - reference_ >= rule_.every : plan.parallax_px >= rule_.parallax_px;
    const bool fits = fits_ring(plan.homography);
    plan.replace = replace_next_ || (far_enough && fits);
    plan.mature = far_enough && (fits || !plan.replace);
    replace_next_ = far_enough && !plan.replace;
  }
  if (plan.replace) {
    reference_ = frame_;
    world_from_reference_ = world_from_robot;
  }
  ++frame_;
  return plan;
}

double ReferencePlan::parallax_px(const Eigen::Matrix3d& homography,
                                  const Eigen::Isometry3d& reference_from_current) const {
  const Eigen::Vector3d point(rule_.distance_m, 0, rule_.height_m);
  const Eigen::Isometry3d camera_from_robot = robot_from_camera_.inverse();
  const Eigen::Vector2d pixel = project(camera_.matrix, camera_from_robot * point);
  const Eigen::Vector2d before =
      project(camera_.matrix, camera_from_robot * (reference_from_current * point));
  return (apply(homography, pixel) - before).norm();
}

bool ReferencePlan::fits_ring(const Eigen::Matrix3d& homography) const {
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const Eigen::Vector2d pixel(roi_.x + (roi_.width - 1) * i / (samples - 1.0),
                                  roi_.y + (roi_.height - 1) * j / (samples - 1.0));
      const Eigen::Vector2d before = apply(homography, pixel);
      const bool in_image = before.x() >= 0 && before.x() < camera_.size.width && before.y() >= 0;
      if (in_image && pixel.y() - std::floor(before.y()) >= margin_rows_) return false;
    }
  }
  return true;
}

}  // namespace floorline
