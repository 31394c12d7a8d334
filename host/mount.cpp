#include "host/mount.h"

#include <cmath>

#include "host/atomic_file.h"
#include "host/yaml_file.h"

namespace floorline {
namespace {

constexpr double rigid_tolerance = 1e-4;

/// Camera axes in the robot frame without pitch and roll: x = right, y = down, z = ahead.
Eigen::Matrix3d level_axes() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1,  //
      -1, 0, 0,     //
      0, -1, 0;
  return axes;
}

}  // namespace

Eigen::Isometry3d robot_from_camera(const MountAngles& angles) {
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() = Eigen::AngleAxisd(angles.pitch_rad, Eigen::Vector3d::UnitY()).toRotationMatrix() *
                   level_axes() *
                   Eigen::AngleAxisd(angles.roll_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  mount.translation() << angles.forward_m, 0, angles.height_m;
  return mount;
}

MountAngles mount_angles(const Eigen::Isometry3d& robot_from_camera) {
  const Eigen::Vector3d down = robot_from_camera.linear().transpose() * -Eigen::Vector3d::UnitZ();
  return {.height_m = robot_from_camera.translation().z(),
          .pitch_rad = std::asin(std::clamp(down.z(), -1.0, 1.0)),
          .roll_rad = std::atan2(down.x(), down.y()),
          .forward_m = robot_from_camera.translation().x()};
}

MountAngles mount_from_plane(const Eigen::Vector3d& normal, double height_m) {
  const double length = normal.norm();
  if (!(std::isfinite(length) && length > 0 && height_m > 0)) {
    throw Error(
        "The floor plane is not below the camera: give a normal that points down and a positive height.");
  }
  const Eigen::Vector3d down = normal / length;
  return {.height_m = height_m / length,
          .pitch_rad = std::asin(down.z()),
          .roll_rad = std::atan2(down.x(), down.y())};
}

Eigen::Isometry3d read_mount(const std::filesystem::path& file) {
  const YamlFile yaml(file);
  const std::vector<double> numbers = yaml.numbers("robot_from_camera");
  if (numbers.size() != 16) yaml.refuse("'robot_from_camera' must have sixteen numbers");
  const Eigen::Matrix4d matrix =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool rigid =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() < rigid_tolerance &&
      rotation.determinant() > 0 && matrix.row(3).isApprox(Eigen::RowVector4d::UnitW());
  if (!rigid)
    yaml.refuse("'robot_from_camera' is no rigid motion (a rotation, a place in metres, a last row 0 0 0 1)");
  if (!(matrix(2, 3) > 0)) yaml.refuse("'robot_from_camera' puts the camera at or below the floor");
  Eigen::Isometry3d mount;
  mount.matrix() = matrix;
  return mount;
}

void write_mount(const Eigen::Isometry3d& robot_from_camera, const std::filesystem::path& file) {
  std::string numbers;
  for (int row = 0; row < 4; ++row) {
    numbers += "\n   ";
    for (int column = 0; column < 4; ++column)
      numbers += fmt::format(" {:.12g},", robot_from_camera.matrix()(row, column));
  }
  numbers.back() = ']';
  write_file(file, fmt::format("robot_from_camera: [{}\n", numbers));
}

}  // namespace floorline
