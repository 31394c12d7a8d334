/// How the camera sits on the robot: robot_from_camera, its file, and what a floor plane says about it.
#ifndef FLOORLINE_HOST_MOUNT_H
#define FLOORLINE_HOST_MOUNT_H

#include <Eigen/Geometry>
#include <filesystem>

namespace floorline {

/// A mount whose optical axis points straight ahead but for a pitch and a roll.
struct MountAngles {
  double height_m = 0.5;
  double pitch_rad = 0;  ///< Downward.
  double roll_rad = 0;   ///< Clockwise as the camera sees it.
  double forward_m = 0;  ///< Lens ahead of the robot's origin.
};

Eigen::Isometry3d robot_from_camera(const MountAngles& angles);

/// Angles of a mount; what it has beyond them (yaw, an offset to the side) is left out.
MountAngles mount_angles(const Eigen::Isometry3d& robot_from_camera);

/// The mount that a floor plane n.X = height gives (camera frame, n pointing down, not necessarily of unit
/// length), the robot's origin being under the lens. Throws Error for a plane that is not below the camera.
MountAngles mount_from_plane(const Eigen::Vector3d& normal, double height_m);

/// Reads mount.yaml (robot_from_camera: 4x4 row-major). Throws Error when it is no rigid motion or the camera
/// is not above the floor.
Eigen::Isometry3d read_mount(const std::filesystem::path& file);
void write_mount(const Eigen::Isometry3d& robot_from_camera, const std::filesystem::path& file);

}  // namespace floorline

#endif
