/// Procedural surface patterns, baked to a tileable image pyramid and read through a pixel's footprint.
#ifndef FLOORLINE_RENDER_TEXTURE_H
#define FLOORLINE_RENDER_TEXTURE_H

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scene.h"

namespace floorline::render {

/// What a pixel sees of a surface: an ellipse, metres on the surface.
struct Footprint {
  Eigen::Vector2f major;  ///< Half axis along the view.
  float minor;            ///< Length of the half axis across it.
};

/// Values 0 to 1 over the plane, repeating every period_m in both directions.
class Texture {
 public:
  /// `texels` (a power of two) a side. The period is about 1.6 mm times `texels`, a whole number of `size_m`.
  Texture(Pattern pattern, double size_m, std::uint64_t seed, int texels);

  /// Mean value under the footprint around `at` (metres on the surface).
  float sample(Eigen::Vector2f at, const Footprint& footprint) const;

 private:
  struct Level {
    int side;
    std::vector<std::uint16_t> values;
  };
  float bilinear(const Level& level, Eigen::Vector2f at) const;
  void add_coarser_levels();

  float period_m_;
  std::vector<Level> levels_;  // side, side / 2, ... 1
};

}  // namespace floorline::render

#endif
