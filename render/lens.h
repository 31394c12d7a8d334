/// Viewing rays of a distorted camera, and back.
#ifndef FLOORLINE_RENDER_LENS_H
#define FLOORLINE_RENDER_LENS_H

#include <Eigen/Core>
#include <vector>

#include "scene.h"

namespace floorline::render {

/// Position of sample i of n in the unit square around 0 (Hammersley set): all rows and columns distinct.
Eigen::Vector2f sample_offset(int i, int n);

class LensRays {
 public:
  LensRays(const ImageFormat& image, const Camera& camera);

  /// Direction (camera frame, z = 1) of sample `s` of a pixel.
  const Eigen::Vector3f& ray(int row, int column, int s) const {
    return rays_[(static_cast<std::size_t>(row) * image_.width + column) * image_.samples + s];
  }
  /// Angle that a pixel covers, radians.
  float pixel_angle() const { return static_cast<float>(1 / camera_.focal_px); }
  /// Whether the image shows this point (camera frame, metres).
  bool in_image(const Eigen::Vector3d& point) const;

 private:
  ImageFormat image_;
  Camera camera_;
  std::vector<Eigen::Vector3f> rays_;
};

}  // namespace floorline::render

#endif
