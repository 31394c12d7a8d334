/// A scene ready for ray tracing: pictures of radiance, masks and visible contact curves from any camera
/// pose.
#ifndef FLOORLINE_RENDER_WORLD_H
#define FLOORLINE_RENDER_WORLD_H

#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "scene.h"
#include "trajectory.h"
#include "truth.h"

namespace floorline::render {

/// What the sensor would see without noise, and what it is.
struct View {
  cv::Mat radiance;  ///< CV_32FC3, blue green red, linear; 1 is a white floor under the lamp.
  cv::Mat mask;      ///< CV_8U, MaskValue.
};

class World {
 public:
  explicit World(const Scene& scene);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  View view(const Eigen::Isometry3d& world_from_camera) const;

  /// Truth of a frame; `mask` is that of its view.
  TrueFrame truth(const TrajectoryFrame& frame, const Eigen::Isometry3d& world_from_camera,
                  const cv::Mat& mask) const;

 private:
  struct Tracer;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace floorline::render

#endif
