#include "host/odometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/atomic_file.h"
#include "host/error.h"
#include "host/text_file.h"

namespace floorline {
namespace {

constexpr auto odometry_header = "frame,timestamp_s,x_m,y_m,yaw_rad";
constexpr double rigid_tolerance = 1e-3;  // KITTI prints seven digits.
/// No robot with wheels moves farther from one frame to the next.
constexpr double farthest_step_m = 10;
/// Farther from the origin of the odometry, a double no longer holds the motion between two frames well.
constexpr double farthest_place_m = 1e7;

/// Refuses a place that cannot be, or that no robot reaches from the row before.
void require_reachable(const std::filesystem::path& file, int line, const Eigen::Vector3d& place,
                       const std::optional<Eigen::Vector3d>& before) {
  if (place.lpNorm<Eigen::Infinity>() > farthest_place_m) {
    refuse_line(file, line,
                fmt::format("the robot is farther than {:g} m from the origin", farthest_place_m));
  }
  if (before && (place - *before).norm() > farthest_step_m) {
    refuse_line(file, line,
                fmt::format("the robot jumps by {:.3g} m, more than {:g} m from one frame to the next",
                            (place - *before).norm(), farthest_step_m));
  }
}

}  // namespace

Eigen::Isometry3d isometry(const PlanarPose& pose) {
  return Eigen::Translation3d(pose.x_m, pose.y_m, 0) *
         Eigen::AngleAxisd(pose.yaw_rad, Eigen::Vector3d::UnitZ());
}

PlanarPose planar(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d rotation = pose.rotation();
  return {pose.translation().x(), pose.translation().y(), std::atan2(rotation(1, 0), rotation(0, 0))};
}

std::vector<OdometrySample> read_odometry(const std::filesystem::path& file) {
  std::vector<OdometrySample> samples;
  for (const NumberRow& row : read_numbers(file, ',', 5, odometry_header)) {
    const double frame = row.values[0];
    const double timestamp_s = row.values[1];
    const auto due = static_cast<double>(samples.size());
    if (frame > due) refuse_line(file, row.line, fmt::format("frame {} is missing", due));
    if (frame != due) refuse_line(file, row.line, fmt::format("frame {} is out of order", frame));
    if (!samples.empty() && timestamp_s <= samples.back().timestamp_s) {
      refuse_line(file, row.line, "the timestamp does not grow");
    }
    const PlanarPose pose = {row.values[2], row.values[3], row.values[4]};
    std::optional<Eigen::Vector3d> before;
    if (!samples.empty()) before = isometry(samples.back().pose).translation();
    require_reachable(file, row.line, isometry(pose).translation(), before);
    if (std::abs(pose.yaw_rad) > farthest_place_m) refuse_line(file, row.line, "the yaw is no angle");
    samples.push_back({timestamp_s, pose});
  }
  return samples;
}

void write_odometry(const std::vector<OdometrySample>& samples, const std::filesystem::path& file) {
  std::string text = fmt::format("{}\n", odometry_header);
  for (std::size_t frame = 0; frame < samples.size(); ++frame) {
    const auto& [timestamp_s, pose] = samples[frame];
    text +=
        fmt::format("{},{:.6f},{:.9g},{:.9g},{:.9g}\n", frame, timestamp_s, pose.x_m, pose.y_m, pose.yaw_rad);
  }
  write_file(file, text);
}

std::vector<Eigen::Isometry3d> read_kitti_poses(const std::filesystem::path& file) {
  std::vector<Eigen::Isometry3d> poses;
  for (const NumberRow& row : read_numbers(file, ' ', 12)) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.matrix().topRows<3>() =
        Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(row.values.data());
    const Eigen::Matrix3d rotation = pose.linear();
    if ((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() > rigid_tolerance ||
        rotation.determinant() < 0) {
      refuse_line(file, row.line, "the pose is no rigid motion");
    }
    std::optional<Eigen::Vector3d> before;
    if (!poses.empty()) before = poses.back().translation();
    require_reachable(file, row.line, pose.translation(), before);
    poses.push_back(pose);
  }
  return poses;
}

void write_kitti_poses(const std::vector<Eigen::Isometry3d>& poses, const std::filesystem::path& file) {
  std::string text;
  for (const Eigen::Isometry3d& pose : poses) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) text += fmt::format("{:.12g} ", pose.matrix()(row, column));
    }
    text.back() = '\n';
  }
  write_file(file, text);
}

std::vector<StampedPose> read_tum_trajectory(const std::filesystem::path& file) {
  std::vector<StampedPose> trajectory;
  for (const NumberRow& row : read_numbers(file, ' ', 8)) {
    const std::vector<double>& v = row.values;
    const Eigen::Quaterniond rotation(v[7], v[4], v[5], v[6]);
    if (std::abs(rotation.norm() - 1) > 0.01)
      refuse_line(file, row.line, "the quaternion is not of unit length");
    if (!trajectory.empty() && v[0] <= trajectory.back().timestamp_s) {
      refuse_line(file, row.line, "the timestamp does not grow");
    }
    trajectory.push_back({v[0], Eigen::Translation3d(v[1], v[2], v[3]) * rotation.normalized()});
  }
  return trajectory;
}

Eigen::Isometry3d pose_at(const std::vector<StampedPose>& trajectory, double timestamp_s,
                          double longest_gap_s) {
  const auto after = std::ranges::lower_bound(trajectory, timestamp_s, {}, &StampedPose::timestamp_s);
  if (after == trajectory.end() || (after == trajectory.begin() && after->timestamp_s > timestamp_s)) {
    throw Error(fmt::format(
        "The trajectory does not reach {:.3f} s: leave out the images that it does not cover.", timestamp_s));
  }
  if (after->timestamp_s == timestamp_s) return after->pose;
  const auto before = std::prev(after);
  const double gap_s = after->timestamp_s - before->timestamp_s;
  if (gap_s > longest_gap_s) {
    throw Error(
        fmt::format("The trajectory has a gap of {:.3f} s around {:.3f} s: leave out the images there.",
                    gap_s, timestamp_s));
  }
  const double share = (timestamp_s - before->timestamp_s) / gap_s;
  const Eigen::Quaterniond first(before->pose.rotation());
  const Eigen::Quaterniond second(after->pose.rotation());
  const Eigen::Vector3d place = (1 - share) * before->pose.translation() + share * after->pose.translation();
  return Eigen::Translation3d(place) * first.slerp(share, second);
}

}  // namespace floorline
