#include "scene_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "trajectory.h"

namespace floorline::render {
namespace {

using Eigen::Vector2d;

constexpr int frames = 21;  // two pairs at a baseline of 8, with room between them
constexpr double robot_radius_m = 0.35;  // kept free around the path
constexpr double view_half_width = 0.6;  // tangent of half the horizontal field of view, a little inside

// A colour of mean reflectance `grey` with a random tint.
Colour tinted(Random& random, double grey, double saturation) {
  Colour colour;
  for (int i = 0; i < 3; ++i) colour[i] = static_cast<float>(grey * (1 + saturation * random.uniform(-1, 1)));
  return colour.cwiseMin(0.95f).cwiseMax(0.02f);
}

// Two shades of one tint, light : dark = contrast.
Material shaded(Random& random, Pattern pattern, double size_m, double grey, double contrast,
                double saturation) {
  Material material{pattern, size_m, tinted(random, grey, saturation), {}};
  material.light = (material.dark * static_cast<float>(std::sqrt(contrast))).cwiseMin(0.95f);
  material.dark /= static_cast<float>(std::sqrt(contrast));
  return material;
}

Material random_floor(Random& random) {
  const double grey = random.uniform(0.15, 0.5), contrast = random.uniform(1.5, 3.0);
  switch (random.pick(5)) {
    case 0:
      return shaded(random, Pattern::tiles, random.uniform(0.2, 0.6), grey, contrast, 0.1);
    case 1:
      return shaded(random, Pattern::wood, random.uniform(0.07, 0.2), grey, contrast, 0.3);
    case 2:
      return shaded(random, Pattern::carpet, 0.1, grey, contrast, 0.3);
    case 3:
      return shaded(random, Pattern::concrete, 0.1, grey, contrast, 0.05);
    default:
      return shaded(random, Pattern::plain, 0.1, grey, contrast, 0.2);
  }
}

Material random_surface(Random& random) {
  const double grey = random.uniform(0.06, 0.6);
  switch (random.pick(8)) {
    case 0:
      return shaded(random, Pattern::stripes, random.uniform(0.08, 0.3), grey, random.uniform(1.5, 6), 0.4);
    case 1:
      return shaded(random, Pattern::posters, random.uniform(0.1, 0.4), grey, random.uniform(2, 6), 0.3);
    case 2:
      return shaded(random, Pattern::wood, random.uniform(0.05, 0.2), grey, random.uniform(1.5, 3), 0.3);
    case 3:
      return shaded(random, Pattern::concrete, 0.1, grey, random.uniform(1.3, 2.5), 0.1);
    case 4:
    case 5:
      return shaded(random, Pattern::fabric, random.uniform(0.01, 0.06), grey, random.uniform(1.5, 4), 0.4);
    default:
      return shaded(random, Pattern::plain, 0.1, grey, random.uniform(1.05, 1.6), 0.4);
  }
}

Camera random_camera(Random& random) {
  Camera camera;
  camera.focal_px = random.uniform(380, 480);
  if (random.chance(0.2)) {
    camera.distortion[0] = random.uniform(-0.15, -0.03);
    camera.distortion[1] = random.uniform(0.0, 0.03);
  }
  camera.forward_m = random.uniform(0.0, 0.25);
  camera.height_m = random.uniform(0.4, 0.9);
  camera.pitch_deg = random.uniform(18, 32);
  camera.roll_deg = random.uniform(-1.5, 1.5);
  return camera;
}

Room random_room(Random& random) {
  Room room;
  room.low = {random.uniform(-2, -1), random.uniform(-3.5, -1.8)};
  room.high = {random.uniform(4.5, 8), random.uniform(1.8, 3.5)};
  room.skirting_m = random.chance(0.7) ? random.uniform(0.05, 0.12) : 0.0;
  room.floor = random_floor(random);
  const Pattern wall = random.chance(0.4) ? Pattern::posters : Pattern::plain;
  room.wall = shaded(random, wall, random.uniform(0.5, 1.2), random.uniform(0.35, 0.7),
                     random.uniform(1.2, 2.5), 0.1);
  room.skirting = shaded(random, Pattern::plain, 0.1, random.uniform(0.1, 0.8), 1.2, 0.1);
  return room;
}

Path random_path(Random& random) {
  Path path;
  path.heading_deg = random.uniform(-8, 8);
  path.sway_deg = random.uniform(0, 0.04);
  const bool turning = random.chance(0.4);
  path.segments = {
      {frames, random.uniform(0.02, 0.08), turning ? random.uniform(-1.2, 1.2) : random.uniform(-0.2, 0.2)}};
  return path;
}

ObstacleShape random_shape(Random& random) {
  ObstacleShape shape;
  shape.yaw_deg = random.uniform(-180, 180);
  shape.material = random_surface(random);
  const double kind = random.uniform();
  if (kind < 0.40) {
    shape.kind = ObstacleKind::box;
    shape.size = {random.uniform(0.12, 0.7), random.uniform(0.12, 0.7), random.uniform(0.12, 1.2)};
  } else if (kind < 0.60) {
    shape.kind = ObstacleKind::cylinder;
    const double diameter = random.uniform(0.1, 0.5);
    shape.size = {diameter, diameter, random.uniform(0.15, 1.0)};
  } else if (kind < 0.72) {
    shape.kind = ObstacleKind::chair;
    shape.size = {random.uniform(0.38, 0.48), random.uniform(0.38, 0.48), random.uniform(0.8, 1.0)};
    shape.leg_m = random.uniform(0.02, 0.045);
  } else if (kind < 0.78) {
    shape.kind = ObstacleKind::table;
    shape.size = {random.uniform(0.5, 0.9), random.uniform(0.5, 1.2), random.uniform(0.45, 0.75)};
    shape.leg_m = random.uniform(0.03, 0.07);
  } else if (kind < 0.92) {
    shape.kind = ObstacleKind::person;
    shape.size = {random.uniform(0.27, 0.33), random.uniform(0.42, 0.55), random.uniform(1.5, 1.95)};
  } else if (kind < 0.96) {
    shape.kind = ObstacleKind::ramp;
    shape.size = {random.uniform(0.5, 1.2), random.uniform(0.5, 1.0), random.uniform(0.05, 0.2)};
  } else {  // lower than an obstacle counts: a cable duct, a book
    shape.kind = ObstacleKind::box;
    shape.size = {random.uniform(0.1, 0.3), random.uniform(0.1, 0.4), random.uniform(0.02, 0.08)};
  }
  return shape;
}

double radius_of(const ObstacleShape& shape) { return shape.size.head<2>().norm() / 2; }

Vector2d random_place(Random& random) {
  const double x = random.uniform(0.9, 5.0);
  return {x, x * view_half_width * random.uniform(-1, 1)};
}

bool fits(const ObstacleShape& shape, const Scene& scene, const std::vector<TrajectoryFrame>& way) {
  constexpr double gap_m = 0.15;
  const double radius = radius_of(shape);
  const auto free_of = [&](const Vector2d& point, double distance) {
    return (shape.position - point).norm() > distance;
  };
  const Vector2d margin = Vector2d::Constant(radius + gap_m);
  return ((shape.position - scene.room.low - margin).array() > 0).all() &&
         ((scene.room.high - shape.position - margin).array() > 0).all() &&
         std::all_of(scene.obstacles.begin(), scene.obstacles.end(),
                     [&](const ObstacleShape& other) {
                       return free_of(other.position, radius + radius_of(other) + gap_m);
                     }) &&
         std::all_of(way.begin(), way.end(), [&](const TrajectoryFrame& frame) {
           return free_of(frame.exact.position, radius + robot_radius_m);
         });
}

Marking random_marking(Random& random) {
  Marking marking;
  const Vector2d middle = random_place(random);
  const bool stripe = random.chance(0.6);
  const Vector2d half = stripe ? Vector2d(random.uniform(0.015, 0.05), random.uniform(0.3, 1.5))
                               : Vector2d(random.uniform(0.1, 0.6), random.uniform(0.1, 0.6));
  const Eigen::Rotation2Dd turn(random.uniform(-M_PI, M_PI));
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    marking.polygon.push_back(middle + turn * Vector2d(x * half.x(), y * half.y()));
  }
  marking.material = stripe ? shaded(random, Pattern::plain, 0.1, random.uniform(0.05, 0.8), 1.1, 0.5)
                            : random_surface(random);
  return marking;
}

}  // namespace

Scene generate_scene(std::uint64_t seed) {
  Random random(seed ^ 0x726f6f6d);
  Scene scene;
  scene.name = fmt::format("room{:04d}", seed);
  scene.seed = seed;
  scene.image.samples = 3;
  scene.camera = random_camera(random);
  scene.sensor = {random.uniform(4000, 15000), random.uniform(5, 20), random.uniform(0, 0.004)};
  scene.room = random_room(random);
  scene.light.position = {random.uniform(0, 4), random.uniform(-1.5, 1.5), random.uniform(2.2, 2.6)};
  scene.light.size_m = random.uniform(0, 0.6);
  scene.light.ambient = random.uniform(0.4, 0.75);
  scene.path = random_path(random);
  scene.odometry = {random.uniform(0.002, 0.01), random.uniform(0.005, 0.03), random.uniform(-0.005, 0.005),
                    random.uniform(0, 0.02), random.uniform(0.1, 0.3)};
  const std::vector<TrajectoryFrame> way = plan_trajectory(scene);
  const int obstacles = 3 + random.pick(5);
  for (int i = 0; i < obstacles; ++i) {
    ObstacleShape shape = random_shape(random);
    for (int attempt = 0; attempt < 30; ++attempt) {
      shape.position = random_place(random);
      if (!fits(shape, scene, way)) continue;
      scene.obstacles.push_back(shape);
      break;
    }
  }
  const int markings = random.pick(4);
  for (int i = 0; i < markings; ++i) scene.markings.push_back(random_marking(random));
  return scene;
}

}  // namespace floorline::render
