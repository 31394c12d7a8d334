#include "host/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hls/accelerator.h"
#include "host/error.h"
#include "host/fixed_point.h"
#include "host/geometry.h"
#include "host/line_table.h"

namespace floorline {
namespace {

cv::Matx33d to_opencv(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

Eigen::Matrix3d to_eigen(const cv::Matx33d& m) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(m.val);
}

template <typename Config>
bool holds(cv::Size size) {
  return size.width <= Config::MAX_WIDTH && size.height <= Config::MAX_HEIGHT;
}

/// Rows of the frame ring of the smallest build that holds such frames.
int ring_rows_for(cv::Size size) {
  if (holds<VgaConfig>(size)) return VgaConfig::MAX_HEIGHT + VgaConfig::MARGIN;
  if (holds<WideConfig>(size)) return WideConfig::MAX_HEIGHT + WideConfig::MARGIN;
  throw Error(
      fmt::format("Frames of {}x{} fit no build of the accelerator: scale them to at most {}x{} or {}x{}.",
                  size.width, size.height, VgaConfig::MAX_WIDTH, VgaConfig::MAX_HEIGHT, WideConfig::MAX_WIDTH,
                  WideConfig::MAX_HEIGHT));
}

/// The rows in which floor is looked at: below the horizon of both image edges.
cv::Rect rows_of_interest(const Camera& camera, const Eigen::Isometry3d& robot_from_camera, int margin_rows) {
  const double horizon = std::max(horizon_row(camera.matrix, robot_from_camera, 0),
                                  horizon_row(camera.matrix, robot_from_camera, camera.size.width - 1));
  const double first = std::max(std::ceil(horizon) + margin_rows, 0.0);
  if (first >= camera.size.height) {
    throw Error(fmt::format(
        "The rows of interest begin {} rows below the horizon, under the image: reduce that margin or tilt "
        "the camera down.",
        margin_rows));
  }
  const int first_row = static_cast<int>(first);
  return {0, first_row, camera.size.width, camera.size.height - first_row};
}

/// As the register holds it: whole 1/256.
double representable_ratio(double ratio) {
  constexpr double most = 1023.0 / 256;
  return std::min(std::round(ratio * 256) / 256, most);
}

/// Q8.16.
int fixed_bound(double pixels) { return static_cast<int>(std::lround(std::ldexp(pixels, 16))); }

/// As the registers hold it.
double representable_bound(double pixels) {
  constexpr double most = 127;
  return std::ldexp(fixed_bound(std::clamp(pixels, -most, most)), -16);
}

}  // namespace

Settings paper_settings() {
  Settings settings;
  settings.threshold = {.floor = 0, .override_high = 0, .low = 0};
  settings.rule = golden::Rule::paper;
  settings.erode = true;
  settings.line_count = 120;
  settings.cluster_gap_m = 0;
  settings.min_lines = 1;
  settings.reference.every = 1;
  return settings;
}

Configuration::Configuration(const Camera& camera, const Eigen::Isometry3d& robot_from_camera,
                             const Settings& settings)
    : camera_(camera),
      robot_from_camera_(robot_from_camera),
      reference_rule_(settings.reference),
      still_px_(settings.still_px),
      still_rows_(settings.still_rows) {
  ring_rows_ = ring_rows_for(camera.size);
  const Eigen::Matrix3d birdseye = floor_from_pixel(camera.matrix, robot_from_camera);
  require_floor_in_view(camera, robot_from_camera);
  roi_ = rows_of_interest(camera, robot_from_camera, settings.roi_margin_rows);
  const std::vector<BeamLine> beam = beam_lines({.focus = focus(camera.matrix, robot_from_camera),
                                                 .image = camera.size,
                                                 .roi_first_row = roi_.y,
                                                 .roi_last_row = roi_.br().y - 1,
                                                 .line_count = settings.line_count});
  lines_ = line_table(beam, camera.size);

  base_.erode_high = settings.erode;
  base_.roi_first_row = roi_.y;
  base_.roi_last_row = roi_.br().y - 1;
  const Eigen::Vector2d middle(roi_.x + (roi_.width - 1) / 2.0, roi_.y + (roi_.height - 1) / 2.0);
  base_.birdseye = to_opencv(scaled_at(birdseye, middle));
  base_.threshold = settings.threshold;
  const double horizon = horizon_row(camera.matrix, robot_from_camera, (camera.size.width - 1) / 2.0);
  base_.rule = {
      .kind = settings.rule,
      .min_rows = settings.min_rows,
      .max_gap = settings.max_gap,
      .horizon_row = std::max(std::round(horizon), -double(camera.size.height)),
      .height_ratio = representable_ratio(settings.least_height_m / robot_from_camera.translation().z())};
  for (const BeamLine& line : beam) base_.lines.push_back({line.first, line.last, line.contact_first});
  base_.displacement.noise = settings.noise;
  base_.cluster_gap_m = settings.cluster_gap_m;
  base_.min_lines = settings.min_lines;
}

double Configuration::parallax_share(double baseline_m) const {
  const double cosine_of_pitch = -robot_from_camera_.linear()(2, 1);
  return baseline_m * cosine_of_pitch / (camera_.matrix(1, 1) * robot_from_camera_.translation().z());
}

ReferencePlan Configuration::reference_plan() const {
  return {camera_, robot_from_camera_, reference_rule_, roi_, ring_rows_ - camera_.size.height};
}

golden::Parameters Configuration::golden_parameters(const PlannedFrame& frame) const {
  golden::Parameters parameters = base_;
  parameters.replace_reference = frame.replace;
  parameters.homography = to_opencv(frame.homography);
  parameters.displacement = displacement(frame);
  return parameters;
}

golden::DisplacementParameters Configuration::displacement(const PlannedFrame& frame) const {
  golden::DisplacementParameters parameters = base_.displacement;
  // The epipole of a robot that drives ahead lies on the horizon.
  const double step = still_rows_ * parallax_share(frame.baseline_m);
  parameters.bound_step_px = representable_bound(step);
  parameters.bound_px = representable_bound(still_px_ - step * base_.rule.horizon_row);
  return parameters;
}

FrameParameters Configuration::frame_parameters(const PlannedFrame& frame, bool grey) const {
  FrameParameters parameters = {};
  parameters.width = camera_.size.width;
  parameters.height = camera_.size.height;
  parameters.grey = grey;
  parameters.replace_reference = frame.replace;
  parameters.erode_high = base_.erode_high;
  parameters.roi_first_row = base_.roi_first_row;
  parameters.roi_last_row = base_.roi_last_row;
  parameters.line_count = lines_.size();
  parameters.cluster_gap = std::lround(std::ldexp(base_.cluster_gap_m, 16));
  parameters.homography = pack_homography(frame.homography, camera_.size, roi_).map;
  parameters.birdseye = pack_birdseye(to_eigen(base_.birdseye), roi_).map;
  parameters.threshold.floor = base_.threshold.floor;
  parameters.threshold.override_high = base_.threshold.override_high;
  parameters.threshold.low = base_.threshold.low;
  const golden::DisplacementParameters foot = displacement(frame);
  parameters.displacement.noise = foot.noise;
  parameters.displacement.bound = fixed_bound(foot.bound_px);
  parameters.displacement.bound_step = fixed_bound(foot.bound_step_px);
  parameters.rule.run_rule = base_.rule.kind == golden::Rule::run;
  parameters.rule.min_rows = base_.rule.min_rows;
  parameters.rule.max_gap = base_.rule.max_gap;
  parameters.rule.horizon_row = static_cast<int>(base_.rule.horizon_row);
  parameters.rule.height_ratio = std::lround(base_.rule.height_ratio * 256);
  parameters.rule.min_lines = base_.min_lines;
  return parameters;
}

std::optional<golden::Lens> rectification(const Camera& camera) {
  if (!camera.distorted()) return std::nullopt;
  return golden::Lens(to_opencv(camera.matrix), camera.distortion, camera.size,
                      golden::Interpolation::bilinear);
}

}  // namespace floorline
