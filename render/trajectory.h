/// The robot's way through a scene: exact poses and what its odometry believes.
#ifndef FLOORLINE_RENDER_TRAJECTORY_H
#define FLOORLINE_RENDER_TRAJECTORY_H

#include <Eigen/Geometry>
#include <vector>

#include "scene.h"

namespace floorline::render {

/// Position (metres) and heading (radians, left positive) on the floor.
struct PlanarPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double yaw = 0;
};

struct TrajectoryFrame {
  PlanarPose exact;
  PlanarPose odometry;                 ///< Starts at the exact pose and drifts.
  Eigen::Isometry3d world_from_robot;  ///< Exact, with the sway that the planar pose leaves out.
};

/// A frame each for all segments of the scene's path; the first stands at its start.
std::vector<TrajectoryFrame> plan_trajectory(const Scene& scene);

/// Pose of the camera (x right, y down, z forward) in the robot frame.
Eigen::Isometry3d robot_from_camera(const Camera& camera);

}  // namespace floorline::render

#endif
