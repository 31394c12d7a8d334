/// A camera on a robot for tests, and the floor as it sees it.
#ifndef FLOORLINE_TB_HOST_RIG_H
#define FLOORLINE_TB_HOST_RIG_H

#include <opencv2/imgproc.hpp>

#include "host/camera.h"
#include "host/geometry.h"
#include "host/mount.h"
#include "host/odometry.h"

namespace floorline {

inline Camera test_camera() {
  Camera camera;
  camera.size = {640, 480};
  camera.matrix << 420, 0, 319.5, 0, 421, 239.5, 0, 0, 1;
  return camera;
}

inline constexpr MountAngles test_angles = {
    .height_m = 0.6, .pitch_rad = 0.44, .roll_rad = 0.02, .forward_m = 0.1};

/// Pixel of a point of the robot frame.
inline Eigen::Vector2d pixel_of(const Camera& camera, const Eigen::Isometry3d& robot_from_camera,
                                const Eigen::Vector3d& point) {
  return project(camera.matrix, robot_from_camera.inverse() * point);
}

/// The floor painted with smooth random grey, seen from `world_from_robot`; grey 128 above the horizon.
inline cv::Mat floor_view(const Camera& camera, const Eigen::Isometry3d& robot_from_camera,
                          const PlanarPose& world_from_robot) {
  constexpr double pixels_per_metre = 100;
  constexpr int side = 2000;
  static const cv::Mat texture = [] {
    cv::Mat noise(side, side, CV_8UC1), smooth;
    cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(noise, smooth, {0, 0}, 2.5);
    cv::normalize(smooth, smooth, 20, 235, cv::NORM_MINMAX);
    return smooth;
  }();
  const Eigen::Isometry3d world = isometry(world_from_robot);
  const Eigen::Matrix3d floor = floor_from_pixel(camera.matrix, robot_from_camera);
  cv::Mat map(camera.size, CV_32FC2);
  for (int v = 0; v < map.rows; ++v) {
    for (int u = 0; u < map.cols; ++u) {
      const Eigen::Vector3d ray = floor * Eigen::Vector3d(u, v, 1);
      const Eigen::Vector3d place = world * Eigen::Vector3d(ray.x() / ray.z(), ray.y() / ray.z(), 0);
      const bool below_horizon = ray.z() > 0;
      map.at<cv::Point2f>(v, u) =
          below_horizon ? cv::Point2f(static_cast<float>(place.x() * pixels_per_metre + side / 4),
                                      static_cast<float>(place.y() * pixels_per_metre + side / 2))
                        : cv::Point2f(-9, -9);
    }
  }
  cv::Mat view;
  cv::remap(texture, view, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(128));
  return view;
}

}  // namespace floorline

#endif
