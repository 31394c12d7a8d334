/// Where the robot was: wheel odometry and full poses, and their files.
#ifndef FLOORLINE_HOST_ODOMETRY_H
#define FLOORLINE_HOST_ODOMETRY_H

#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

namespace floorline {

/// Place and heading on the floor, in the odometry frame.
struct PlanarPose {
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;  ///< Counterclockwise.
};

/// The pose with Z = 0 and no tilt.
Eigen::Isometry3d isometry(const PlanarPose& pose);

/// Place and heading of a full pose.
PlanarPose planar(const Eigen::Isometry3d& pose);

/// A line of odometry.csv; frame i is line i.
struct OdometrySample {
  double timestamp_s = 0;
  PlanarPose pose;
};

/// Reads odometry.csv. Throws Error for a line that is malformed or not finite, a frame that is missing or
/// out of order, a timestamp that does not grow, and a place that no robot reaches from the row before.
std::vector<OdometrySample> read_odometry(const std::filesystem::path& file);
void write_odometry(const std::vector<OdometrySample>& samples, const std::filesystem::path& file);

/// Reads KITTI's poses.txt: a 3x4 matrix a line, row-major. Throws Error for a line that is malformed, not
/// finite, no rigid motion, or a place that no robot reaches from the row before.
std::vector<Eigen::Isometry3d> read_kitti_poses(const std::filesystem::path& file);
void write_kitti_poses(const std::vector<Eigen::Isometry3d>& poses, const std::filesystem::path& file);

struct StampedPose {
  double timestamp_s = 0;
  Eigen::Isometry3d pose;
};

/// Reads a TUM trajectory: "timestamp tx ty tz qx qy qz qw" a line. Throws Error for a line that is malformed
/// or not finite, a quaternion without length, and a timestamp that does not grow.
std::vector<StampedPose> read_tum_trajectory(const std::filesystem::path& file);

/// The pose at a time, interpolated between its neighbours. Throws Error when the trajectory does not reach
/// there or its neighbours are more than longest_gap_s apart.
Eigen::Isometry3d pose_at(const std::vector<StampedPose>& trajectory, double timestamp_s,
                          double longest_gap_s);

}  // namespace floorline

#endif
