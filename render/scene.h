/// A scene: everything the renderer needs to make one sequence with exact ground truth.
/// SCENE.yaml is its file form; docs/rendered_set.md lists every key. Metres, degrees, robot conventions (X
/// forward, Y left, Z up).
#ifndef FLOORLINE_RENDER_SCENE_H
#define FLOORLINE_RENDER_SCENE_H

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace floorline::render {

/// Linear reflectance of red, green and blue, 0 to 1.
using Colour = Eigen::Vector3f;

/// Procedural patterns; texture.h says what each looks like.
enum class Pattern { plain, tiles, wood, carpet, concrete, fabric, stripes, posters };

/// A surface: a pattern of values between 0 and 1 that mixes two colours.
struct Material {
  Pattern pattern = Pattern::plain;
  double size_m = 0.3;  ///< Pitch of tiles, planks, stripes or posters.
  Colour dark{0.3f, 0.3f, 0.3f};
  Colour light{0.5f, 0.5f, 0.5f};
};

struct ImageFormat {
  int width = 640;
  int height = 480;
  double fps = 25.0;
  int samples = 4;  ///< Rays a pixel, 1 to 16.
  bool colour = false;
};

/// Pinhole camera with lens distortion on the robot; the principal point is the image centre.
struct Camera {
  double focal_px = 420.0;
  double distortion[5] = {0, 0, 0, 0, 0};  ///< k1 k2 p1 p2 k3, as OpenCV.
  double forward_m = 0.1;                  ///< Lens ahead of the wheel axis.
  double height_m = 0.6;
  double pitch_deg = 25.0;  ///< Downward.
  double roll_deg = 0.0;    ///< Clockwise as the camera sees it.
};

/// Sensor: shot noise of a full well, read noise, and an exposure that wanders.
struct Sensor {
  double full_well_e = 8000.0;
  double read_noise_e = 12.0;
  double exposure_drift = 0.003;  ///< Standard deviation of the relative step from frame to frame.
};

/// One lamp, square and horizontal, over light from everywhere.
struct Light {
  Eigen::Vector3d position{1.0, 0.5, 2.5};
  double size_m = 0.3;   ///< Side of the lamp; 0 gives hard shadows.
  double ambient = 0.5;  ///< Share of the light on the floor under the lamp that has no shadow.
};

/// The four walls around a rectangular floor.
struct Room {
  Eigen::Vector2d low{-2.0, -2.5};
  Eigen::Vector2d high{6.0, 2.5};
  double height_m = 2.6;
  double skirting_m = 0.08;  ///< Height of the skirting board, 0 for none.
  Material floor;
  Material wall;
  Material skirting;
};

enum class ObstacleKind { box, cylinder, chair, table, person, ramp };

/// Something that stands on the floor. size = depth (along its own x), width, height. A cylinder's base is an
/// ellipse; a ramp rises along its x; chair and table stand on four legs of leg_m.
struct ObstacleShape {
  ObstacleKind kind = ObstacleKind::box;
  Eigen::Vector2d position{2.0, 0.0};
  double yaw_deg = 0.0;
  Eigen::Vector3d size{0.3, 0.3, 0.3};
  double leg_m = 0.03;
  Material material;
};

/// Paint, tape or a thin rug: a flat convex polygon on the floor, no obstacle.
struct Marking {
  std::vector<Eigen::Vector2d> polygon;
  Material material;
};

/// A piece of the robot's way: so many frames, each this far and this much of a turn (left positive).
struct PathSegment {
  int frames = 40;
  double step_m = 0.04;
  double turn_deg = 0.0;
};

struct Path {
  Eigen::Vector2d start{0.0, 0.0};
  double heading_deg = 0.0;
  double sway_deg =
      0.0;  ///< Standard deviation of the pitch and roll of the robot that its odometry cannot see.
  std::vector<PathSegment> segments{PathSegment{}};
};

/// What the wheel odometry gets wrong.
struct OdometryNoise {
  double distance = 0.005;        ///< Standard deviation relative to each step.
  double turn_deg = 0.02;         ///< Standard deviation a step.
  double scale = 0.0;             ///< Relative error of every distance.
  double slip_probability = 0.0;  ///< A step in which the wheels turn further than the robot goes,
  double slip_share = 0.2;        ///< by this share.
};

struct Scene {
  std::string name = "scene";
  std::uint64_t seed = 1;  ///< Of noise and textures; the same scene and seed give the same bytes.
  ImageFormat image;
  Camera camera;
  Sensor sensor;
  Light light;
  Room room;
  std::vector<ObstacleShape> obstacles;
  std::vector<Marking> markings;
  Path path;
  OdometryNoise odometry;

  int frame_count() const;
};

/// Reads a scene; keys that are left out keep the defaults above. Throws Error with one sentence
/// that names the key and what is allowed when a key is unknown, a value is malformed or out of range.
Scene read_scene(const std::filesystem::path& file);

/// The same from text; `name` is how messages call it.
Scene parse_scene(const std::string& yaml, const std::string& name);

/// SCENE.yaml text that parse_scene reads back to the same scene.
std::string scene_to_yaml(const Scene& scene);

}  // namespace floorline::render

#endif
