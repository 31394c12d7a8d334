#include "trajectory.h"

#include <cmath>

#include "noise.h"

namespace floorline::render {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double degree = M_PI / 180;

// One step of `distance` along the mean heading of a turn.
PlanarPose advanced(const PlanarPose& from, double distance, double turn) {
  const double heading = from.yaw + turn / 2;
  return {from.position + distance * Eigen::Vector2d(std::cos(heading), std::sin(heading)), from.yaw + turn};
}

Eigen::Isometry3d with_sway(const PlanarPose& pose, double pitch, double roll) {
  Eigen::Isometry3d full = Eigen::Isometry3d::Identity();
  full.translation() << pose.position, 0;
  full.linear() = (AngleAxisd(pose.yaw, Vector3d::UnitZ()) * AngleAxisd(pitch, Vector3d::UnitY()) *
                   AngleAxisd(roll, Vector3d::UnitX()))
                      .toRotationMatrix();
  return full;
}

// What the wheels tell of a step.
PlanarPose measured_step(const OdometryNoise& noise, const PlanarPose& from, double distance, double turn,
                         Random& random) {
  double told = distance * (1 + noise.scale + noise.distance * random.normal());
  if (random.chance(noise.slip_probability)) told += distance * noise.slip_share;
  return advanced(from, told, turn + noise.turn_deg * degree * random.normal());
}

}  // namespace

std::vector<TrajectoryFrame> plan_trajectory(const Scene& scene) {
  Random random(scene.seed ^ 0x7261'6a65'6374'6f72);
  const Path& path = scene.path;
  const PlanarPose start{path.start, path.heading_deg * degree};
  std::vector<TrajectoryFrame> frames;
  for (const PathSegment& segment : path.segments) {
    for (int i = 0; i < segment.frames; ++i) {
      TrajectoryFrame frame{start, start, {}};
      if (!frames.empty()) {
        const double turn = segment.turn_deg * degree;
        frame.exact = advanced(frames.back().exact, segment.step_m, turn);
        frame.odometry = measured_step(scene.odometry, frames.back().odometry, segment.step_m, turn, random);
      }
      const double sway = path.sway_deg * degree;
      frame.world_from_robot = with_sway(frame.exact, sway * random.normal(), sway * random.normal());
      frames.push_back(frame);
    }
  }
  return frames;
}

Eigen::Isometry3d robot_from_camera(const Camera& camera) {
  const double pitch = camera.pitch_deg * degree;
  Eigen::Matrix3d axes;  // columns: the camera's x, y, z in the robot frame, before roll
  axes << 0, -std::sin(pitch), std::cos(pitch),  //
      -1, 0, 0,                                  //
      0, -std::cos(pitch), -std::sin(pitch);
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
  mount.linear() = axes * AngleAxisd(camera.roll_deg * degree, Vector3d::UnitZ()).toRotationMatrix();
  mount.translation() << camera.forward_m, 0, camera.height_m;
  return mount;
}

}  // namespace floorline::render
