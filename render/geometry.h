/// Shapes of a scene as triangle meshes and as outlines on the floor.
#ifndef FLOORLINE_RENDER_GEOMETRY_H
#define FLOORLINE_RENDER_GEOMETRY_H

#include <Eigen/Core>
#include <vector>

#include "scene.h"
#include "truth.h"

namespace floorline::render {

/// Triangles of one material that the truth masks call by one value. World frame, metres.
struct Mesh {
  struct Vertex {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;
    Eigen::Vector2f surface;  ///< Texture coordinates, metres on the surface.
  };
  using Triangle = Eigen::Matrix<std::uint32_t, 3, 1>;

  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  Material material;
  int mask_value = 0;
};

/// All surfaces: floor, markings, walls, skirting boards, then an obstacle each.
std::vector<Mesh> build_meshes(const Scene& scene);

/// Where an obstacle touches the floor: convex outlines, counter-clockwise from above, one a leg.
std::vector<Polyline> footprints(const ObstacleShape& shape);

/// Floor lines of the four walls, the room on their left.
std::vector<Polyline> wall_feet(const Room& room);

}  // namespace floorline::render

#endif
