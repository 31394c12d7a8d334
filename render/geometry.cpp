#include "geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace floorline::render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int round_sides = 40;        // of circles
constexpr float marking_lift = 1e-4f;  // lays each marking over those before it; too flat to see

double radians(double degrees) { return degrees * M_PI / 180; }

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.emplace_back(a, b, c);
}

// A flat convex polygon, counter-clockwise about its normal; texture coordinates run along its first edge.
void add_polygon(Mesh& mesh, const std::vector<Vector3f>& corners,
                 Vector2f texture_origin = Vector2f::Zero()) {
  const Vector3f u = (corners[1] - corners[0]).normalized();
  const Vector3f normal = u.cross(corners[2] - corners[0]).normalized();
  const Vector3f v = normal.cross(u);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3f& corner : corners) {
    const Vector3f local = corner - corners[0];
    mesh.vertices.push_back({corner, normal, texture_origin + Vector2f(u.dot(local), v.dot(local))});
  }
  for (std::uint32_t i = 2; i < corners.size(); ++i) add_triangle(mesh, first, first + i - 1, first + i);
}

// An upright box around `middle` of the floor plane, from z = low to high.
void add_box(Mesh& mesh, Vector2f middle, Vector2f size, float low, float high) {
  const Vector2f half = size / 2;
  const auto at = [&](float sx, float sy, float z) {
    return Vector3f(middle.x() + sx * half.x(), middle.y() + sy * half.y(), z);
  };
  const float corner_x[4] = {-1, 1, 1, -1}, corner_y[4] = {-1, -1, 1, 1};
  float around = 0;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    add_polygon(mesh,
                {at(corner_x[i], corner_y[i], low), at(corner_x[j], corner_y[j], low),
                 at(corner_x[j], corner_y[j], high), at(corner_x[i], corner_y[i], high)},
                Vector2f(around, low));
    around += i % 2 ? size.y() : size.x();
  }
  add_polygon(mesh, {at(-1, -1, high), at(1, -1, high), at(1, 1, high), at(-1, 1, high)});
  add_polygon(mesh, {at(-1, 1, low), at(1, 1, low), at(1, -1, low), at(-1, -1, low)});
}

// An ellipse at height z: middle and half axes.
struct Ring {
  Vector2f middle;
  Vector2f radius;
  float z;
};

// Skin between two rings, with smooth normals, and a lid on the upper one.
void add_tube(Mesh& mesh, const Ring& low, const Ring& high) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const float mean_radius = (low.radius.sum() + high.radius.sum()) / 4;
  std::vector<Vector3f> lid;
  for (int i = 0; i <= round_sides; ++i) {
    const auto turn = static_cast<float>(2 * M_PI * i / round_sides);
    const Vector2f direction(std::cos(turn), std::sin(turn));
    const Vector2f outward = direction.cwiseProduct(low.radius.reverse()).normalized();
    for (const Ring* ring : {&low, &high}) {
      const Vector2f at = ring->middle + direction.cwiseProduct(ring->radius);
      mesh.vertices.push_back({Vector3f(at.x(), at.y(), ring->z), Vector3f(outward.x(), outward.y(), 0),
                               Vector2f(turn * mean_radius, ring->z)});
      if (ring == &high && i < round_sides) lid.emplace_back(at.x(), at.y(), ring->z);
    }
  }
  for (std::uint32_t i = 0; i < round_sides; ++i) {
    const std::uint32_t a = first + 2 * i;
    add_triangle(mesh, a, a + 2, a + 3);
    add_triangle(mesh, a, a + 3, a + 1);
  }
  add_polygon(mesh, lid);
}

void add_tube(Mesh& mesh, Vector2f middle, Vector2f radius, float low, float high) {
  add_tube(mesh, {middle, radius, low}, {middle, radius, high});
}

// Middles of the four legs of a chair or table, its own frame.
std::vector<Vector2d> leg_middles(const ObstacleShape& shape) {
  const double x = (shape.size.x() - shape.leg_m) / 2, y = (shape.size.y() - shape.leg_m) / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

void add_legs_and_seat(Mesh& mesh, const ObstacleShape& shape, double seat_m) {
  constexpr double board_m = 0.03;
  const Vector2f leg = Vector2f::Constant(static_cast<float>(shape.leg_m));
  for (const Vector2d& middle : leg_middles(shape)) {
    add_box(mesh, middle.cast<float>(), leg, 0, static_cast<float>(seat_m - board_m));
  }
  add_box(mesh, Vector2f::Zero(), shape.size.head<2>().cast<float>(), static_cast<float>(seat_m - board_m),
          static_cast<float>(seat_m));
}

void add_chair(Mesh& mesh, const ObstacleShape& shape) {
  add_legs_and_seat(mesh, shape, 0.5 * shape.size.z());
  const auto depth = static_cast<float>(shape.leg_m);
  const auto width = static_cast<float>(shape.size.y());
  const Vector2f back(static_cast<float>(-shape.size.x() / 2) + depth / 2, 0);
  const auto top = static_cast<float>(shape.size.z());
  add_box(mesh, back, {depth, width}, 0.7f * top, top);
  for (const float side : {-1.0f, 1.0f}) {
    add_box(mesh, back + Vector2f(0, side * (width - depth) / 2), {depth, depth}, 0.5f * top, 0.7f * top);
  }
}

// A person of size (depth, width, height): proportions as shares of these.
struct Shoe {
  static constexpr double side = 0.2, length = 0.85, width = 0.2, height = 0.05;
};

void add_person(Mesh& mesh, const ObstacleShape& shape) {
  const auto depth = static_cast<float>(shape.size.x());
  const auto width = static_cast<float>(shape.size.y());
  const auto height = static_cast<float>(shape.size.z());
  const auto ring = [&](float y, float rx, float ry, float z) {
    return Ring{{0, y * width}, {rx * depth, ry * width}, z * height};
  };
  for (const float side : {-1.0f, 1.0f}) {
    const auto foot = side * static_cast<float>(Shoe::side);
    add_tube(mesh, {0, foot * width},
             {static_cast<float>(Shoe::length) / 2 * depth, static_cast<float>(Shoe::width) / 2 * width}, 0,
             static_cast<float>(Shoe::height) * height);
    add_tube(mesh, ring(foot, 0.2f, 0.1f, 0.05f), ring(side * 0.18f, 0.3f, 0.17f, 0.48f));
    add_tube(mesh, ring(side * 0.5f, 0.15f, 0.08f, 0.44f), ring(side * 0.42f, 0.2f, 0.11f, 0.8f));
  }
  add_tube(mesh, ring(0, 0.36f, 0.33f, 0.46f), ring(0, 0.4f, 0.42f, 0.82f));
  add_tube(mesh, ring(0, 0.2f, 0.12f, 0.82f), ring(0, 0.2f, 0.12f, 0.87f));
  add_tube(mesh, ring(0, 0.3f, 0.17f, 0.87f), ring(0, 0.28f, 0.16f, 1.0f));
}

void add_ramp(Mesh& mesh, const ObstacleShape& shape) {
  const Vector3f half = shape.size.cast<float>() / 2;
  const float x = half.x(), y = half.y(), z = 2 * half.z();
  const Vector3f a(-x, -y, 0), b(x, -y, 0), c(x, y, 0), d(-x, y, 0), e(x, -y, z), f(x, y, z);
  add_polygon(mesh, {a, e, f, d});
  add_polygon(mesh, {b, c, f, e});
  add_polygon(mesh, {a, b, e});
  add_polygon(mesh, {c, d, f});
}

void to_world(Mesh& mesh, const ObstacleShape& shape) {
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(static_cast<float>(radians(shape.yaw_deg)), Vector3f::UnitZ()).toRotationMatrix();
  const Vector3f shift(static_cast<float>(shape.position.x()), static_cast<float>(shape.position.y()), 0);
  for (Mesh::Vertex& vertex : mesh.vertices) {
    vertex.position = turn * vertex.position + shift;
    vertex.normal = turn * vertex.normal;
  }
}

Mesh obstacle_mesh(const ObstacleShape& shape, int id) {
  Mesh mesh;
  mesh.material = shape.material;
  mesh.mask_value = MaskValue::first_obstacle + id;
  const Vector2f size = shape.size.head<2>().cast<float>();
  const auto height = static_cast<float>(shape.size.z());
  switch (shape.kind) {
    case ObstacleKind::box:
      add_box(mesh, Vector2f::Zero(), size, 0, height);
      break;
    case ObstacleKind::cylinder:
      add_tube(mesh, Vector2f::Zero(), size / 2, 0, height);
      break;
    case ObstacleKind::chair:
      add_chair(mesh, shape);
      break;
    case ObstacleKind::table:
      add_legs_and_seat(mesh, shape, shape.size.z());
      break;
    case ObstacleKind::person:
      add_person(mesh, shape);
      break;
    case ObstacleKind::ramp:
      add_ramp(mesh, shape);
      break;
  }
  to_world(mesh, shape);
  return mesh;
}

Polyline rectangle(Vector2d middle, Vector2d size) {
  const Vector2d half = size / 2;
  return {middle + Vector2d(-half.x(), -half.y()), middle + Vector2d(half.x(), -half.y()), middle + half,
          middle + Vector2d(-half.x(), half.y())};
}

Polyline ellipse(Vector2d middle, Vector2d radius) {
  Polyline outline;
  for (int i = 0; i < round_sides; ++i) {
    const double turn = 2 * M_PI * i / round_sides;
    outline.push_back(middle + Vector2d(std::cos(turn), std::sin(turn)).cwiseProduct(radius));
  }
  return outline;
}

std::vector<Polyline> local_footprints(const ObstacleShape& shape) {
  const Vector2d size = shape.size.head<2>();
  switch (shape.kind) {
    case ObstacleKind::box:
    case ObstacleKind::ramp:
      return {rectangle(Vector2d::Zero(), size)};
    case ObstacleKind::cylinder:
      return {ellipse(Vector2d::Zero(), size / 2)};
    case ObstacleKind::chair:
    case ObstacleKind::table: {
      std::vector<Polyline> feet;
      for (const Vector2d& middle : leg_middles(shape)) {
        feet.push_back(rectangle(middle, Vector2d::Constant(shape.leg_m)));
      }
      return feet;
    }
    case ObstacleKind::person: {
      std::vector<Polyline> feet;
      for (const double side : {-Shoe::side, Shoe::side}) {
        feet.push_back(
            ellipse({0, side * size.y()}, {Shoe::length / 2 * size.x(), Shoe::width / 2 * size.y()}));
      }
      return feet;
    }
  }
  return {};
}

Mesh flat(const std::vector<Vector3f>& corners, const Material& material, int mask_value) {
  Mesh mesh;
  mesh.material = material;
  mesh.mask_value = mask_value;
  add_polygon(mesh, corners);
  return mesh;
}

Mesh marking_mesh(const Marking& marking, float lift) {
  std::vector<Vector3f> corners;
  for (const Vector2d& corner : marking.polygon) {
    corners.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()), lift);
  }
  const Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (normal.z() < 0) std::reverse(corners.begin(), corners.end());
  return flat(corners, marking.material, MaskValue::marking);
}

void add_walls(std::vector<Mesh>& meshes, const Room& room) {
  constexpr float board_m = 0.012f;  // thickness of the skirting board
  for (const Polyline& foot : wall_feet(room)) {
    const Vector2f a = foot[0].cast<float>(), b = foot[1].cast<float>();
    const Vector2f along = (b - a).normalized();
    const Vector2f inward(-along.y(), along.x());
    const auto panel = [&](Vector2f shift, float low, float high, const Material& material) {
      const Vector2f from = a + shift, to = b + shift;
      meshes.push_back(flat({{to.x(), to.y(), low},
                             {from.x(), from.y(), low},
                             {from.x(), from.y(), high},
                             {to.x(), to.y(), high}},
                            material, MaskValue::wall));
    };
    panel(inward * 0.0f, 0, static_cast<float>(room.height_m), room.wall);
    if (room.skirting_m > 0) {
      panel(inward * board_m, 0, static_cast<float>(room.skirting_m), room.skirting);
    }
  }
}

}  // namespace

std::vector<Mesh> build_meshes(const Scene& scene) {
  const Vector2f low = scene.room.low.cast<float>(), high = scene.room.high.cast<float>();
  std::vector<Mesh> meshes;
  meshes.push_back(
      flat({{low.x(), low.y(), 0}, {high.x(), low.y(), 0}, {high.x(), high.y(), 0}, {low.x(), high.y(), 0}},
           scene.room.floor, MaskValue::floor));
  for (std::size_t i = 0; i < scene.markings.size(); ++i) {
    meshes.push_back(marking_mesh(scene.markings[i], marking_lift * static_cast<float>(i + 1)));
  }
  add_walls(meshes, scene.room);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    meshes.push_back(obstacle_mesh(scene.obstacles[i], static_cast<int>(i)));
  }
  return meshes;
}

std::vector<Polyline> footprints(const ObstacleShape& shape) {
  const Eigen::Rotation2Dd turn(radians(shape.yaw_deg));
  std::vector<Polyline> feet = local_footprints(shape);
  for (Polyline& foot : feet) {
    for (Vector2d& point : foot) point = turn * point + shape.position;
  }
  return feet;
}

std::vector<Polyline> wall_feet(const Room& room) {
  const Polyline corners{room.low, {room.high.x(), room.low.y()}, room.high, {room.low.x(), room.high.y()}};
  std::vector<Polyline> feet;
  for (std::size_t i = 0; i < 4; ++i) feet.push_back({corners[i], corners[(i + 1) % 4]});
  return feet;
}

}  // namespace floorline::render
