#include "host/geometry.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "host/error.h"

namespace floorline {
namespace {

/// Direction of the robot's Z axis against the ray of pixel (u, v): a u + b v + c, negative below the
/// horizon.
Eigen::RowVector3d height_of_ray(const Eigen::Matrix3d& camera_matrix,
                                 const Eigen::Isometry3d& robot_from_camera) {
  return robot_from_camera.linear().row(2) * camera_matrix.inverse();
}

}  // namespace

Eigen::Vector2d project(const Eigen::Matrix3d& camera_matrix, const Eigen::Vector3d& point) {
  return (camera_matrix * point).hnormalized();
}

Eigen::Matrix3d pixel_from_floor(const Eigen::Matrix3d& camera_matrix,
                                 const Eigen::Isometry3d& robot_from_camera) {
  const Eigen::Isometry3d camera_from_robot = robot_from_camera.inverse();
  Eigen::Matrix3d floor_axes;
  floor_axes << camera_from_robot.linear().leftCols<2>(), camera_from_robot.translation();
  return camera_matrix * floor_axes;
}

Eigen::Matrix3d floor_from_pixel(const Eigen::Matrix3d& camera_matrix,
                                 const Eigen::Isometry3d& robot_from_camera) {
  if (!camera_matrix.allFinite() || !robot_from_camera.matrix().allFinite()) {
    throw Error("The camera matrix or the mount holds a number that is not finite: calibrate again.");
  }
  const double height = robot_from_camera.translation().z();
  if (!(height > 0)) throw Error("The camera is not above the floor: correct the height in the mount.");
  // The determinant of pixel_from_floor is fx fy height, so it can be inverted. A floor point in front of the
  // camera has a positive depth there, and 1 / depth here.
  return pixel_from_floor(camera_matrix, robot_from_camera).inverse();
}

Eigen::Matrix3d ground_homography(const Eigen::Matrix3d& camera_matrix,
                                  const Eigen::Isometry3d& robot_from_camera,
                                  const Eigen::Isometry3d& reference_from_current) {
  const Eigen::Isometry3d current_from_reference_camera =
      reference_from_current.inverse() * robot_from_camera;
  const Eigen::Matrix3d homography = pixel_from_floor(camera_matrix, current_from_reference_camera) *
                                     floor_from_pixel(camera_matrix, robot_from_camera);
  if (!homography.allFinite()) throw Error("The odometry holds a number that is not finite: correct it.");
  return homography;
}

Eigen::Vector3d focus(const Eigen::Matrix3d& camera_matrix, const Eigen::Isometry3d& robot_from_camera) {
  return camera_matrix * (robot_from_camera.linear().transpose() * -Eigen::Vector3d::UnitZ());
}

double horizon_row(const Eigen::Matrix3d& camera_matrix, const Eigen::Isometry3d& robot_from_camera,
                   double u) {
  const Eigen::RowVector3d height = height_of_ray(camera_matrix, robot_from_camera);
  const double fall = -height.y();  // Rays sink by this from row to row.
  if (!(fall > 0)) return -std::numeric_limits<double>::infinity();
  return (height.x() * u + height.z()) / fall;
}

void require_floor_in_view(const Camera& camera, const Eigen::Isometry3d& robot_from_camera) {
  const Eigen::RowVector3d height = height_of_ray(camera.matrix, robot_from_camera);
  const double left = height.dot(Eigen::RowVector3d(0, camera.size.height - 1, 1));
  const double right = height.dot(Eigen::RowVector3d(camera.size.width - 1, camera.size.height - 1, 1));
  if (!(std::min(left, right) < 0)) {
    throw Error(
        "The camera looks above the horizon and sees no floor: correct the mount or tilt the camera down.");
  }
}

Eigen::Matrix3d scaled_at(const Eigen::Matrix3d& map, const Eigen::Vector2d& pixel) {
  const double denominator = map.row(2).dot(pixel.homogeneous());
  const Eigen::Matrix3d scaled = map / denominator;
  if (!scaled.allFinite()) {
    throw Error(
        "A projective map is singular or not finite where it is needed: check calibration, mount and "
        "odometry.");
  }
  return scaled;
}

Eigen::Vector2d apply(const Eigen::Matrix3d& map, const Eigen::Vector2d& point) {
  return (map * point.homogeneous()).hnormalized();
}

}  // namespace floorline
