#include "scene.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>
#include <utility>

#include "host/camera.h"
#include "host/error.h"
#include "host/text_file.h"

namespace floorline::render {
namespace {

struct Limits {
  double low;
  double high;
};
constexpr Limits anywhere{-1000.0, 1000.0};
constexpr Limits share{0.0, 1.0};
constexpr Limits angle{-360.0, 360.0};

using Names = std::vector<std::string>;  // in the order of the enum
const Names pattern_names{"plain", "tiles", "wood", "carpet", "concrete", "fabric", "stripes", "posters"};
const Names kind_names{"box", "cylinder", "chair", "table", "person", "ramp"};

std::string joined(const Names& names) { return fmt::format("{}", fmt::join(names, ", ")); }

// Fills structs from YAML. Reader and Writer below have the same calls, so that `describe` lists every key
// once.
class Reader {
 public:
  Reader(YAML::Node node, std::string where) : node_(std::move(node)), where_(std::move(where)) {
    if (!node_.IsMap()) fail("must be a block of 'key: value' lines");
  }

  void text(const char* key, std::string& value) {
    if (auto found = find(key)) value = scalar<std::string>(found, key, "a word");
  }
  void number(const char* key, double& value, Limits limits) {
    if (auto found = find(key)) value = bounded(found, key, limits);
  }
  void number(const char* key, int& value, Limits limits) {
    auto found = find(key);
    if (!found) return;
    const double real = bounded(found, key, limits);
    if (real != std::floor(real)) fail(fmt::format("'{}' must be a whole number", key));
    value = static_cast<int>(real);
  }
  void number(const char* key, std::uint64_t& value) {
    if (auto found = find(key))
      value = scalar<std::uint64_t>(found, key, "a whole number that is not negative");
  }
  void flag(const char* key, bool& value) {
    if (auto found = find(key)) value = scalar<bool>(found, key, "true or false");
  }
  template <typename Vector>
  void vector(const char* key, Vector& value, Limits limits) {
    if (auto found = find(key)) fill(found, key, value, static_cast<std::size_t>(value.size()), limits);
  }
  template <std::size_t N>
  void vector(const char* key, double (&value)[N], Limits limits) {
    if (auto found = find(key)) fill(found, key, value, N, limits);
  }
  template <typename Enum>
  void choice(const char* key, Enum& value, const Names& names) {
    auto found = find(key);
    if (!found) return;
    const std::string name = scalar<std::string>(found, key, "a word");
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) {
        value = static_cast<Enum>(i);
        return;
      }
    }
    fail(fmt::format("'{}' is '{}'; choose from {}", key, name, joined(names)));
  }
  template <typename Struct>
  void block(const char* key, Struct& value) {
    if (auto found = find(key)) read_into(found, fmt::format("{}.{}", where_, key), value);
  }
  template <typename Struct>
  void list(const char* key, std::vector<Struct>& values) {
    auto found = find(key);
    if (!found) return;
    if (!found.IsSequence()) fail(fmt::format("'{}' must be a list of '- ...' items", key));
    values.assign(found.size(), Struct{});
    for (std::size_t i = 0; i < values.size(); ++i) {
      read_into(found[i], fmt::format("{}.{}[{}]", where_, key, i), values[i]);
    }
  }
  void points(const char* key, std::vector<Eigen::Vector2d>& values) {
    auto found = find(key);
    if (!found) return;
    if (!found.IsSequence() || found.size() < 3)
      fail(fmt::format("'{}' needs at least 3 points [x, y]", key));
    values.assign(found.size(), Eigen::Vector2d::Zero());
    for (std::size_t i = 0; i < values.size(); ++i) fill(found[i], key, values[i], 2, anywhere);
  }

  template <typename Struct>
  static void read_into(const YAML::Node& node, const std::string& where, Struct& value) {
    Reader reader(node, where);
    describe(reader, value);
    for (const auto& entry : reader.node_) {
      const auto key = entry.first.as<std::string>("?");
      if (!reader.known_.count(key)) {
        reader.fail(fmt::format("'{}' is no key here; known are {}", key,
                                joined(Names(reader.known_.begin(), reader.known_.end()))));
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: {}.", where_, what)); }
  YAML::Node find(const char* key) {
    known_.insert(key);
    const YAML::Node& node = node_;  // a look-up on a mutable node would add the key
    return node[key] ? node[key] : YAML::Node(YAML::NodeType::Undefined);
  }
  template <typename T>
  T scalar(const YAML::Node& node, const char* key, const char* expected) const {
    T value;
    if (!node.IsScalar() || !YAML::convert<T>::decode(node, value)) {
      fail(fmt::format("'{}' must be {}", key, expected));
    }
    return value;
  }
  double bounded(const YAML::Node& node, const char* key, Limits limits) const {
    const double value = scalar<double>(node, key, "a number");
    if (!(value >= limits.low && value <= limits.high)) {
      fail(fmt::format("'{}' is {} and must lie between {} and {}", key, value, limits.low, limits.high));
    }
    return value;
  }
  template <typename Vector>
  void fill(const YAML::Node& node, const char* key, Vector& value, std::size_t size, Limits limits) const {
    if (!node.IsSequence() || node.size() != size)
      fail(fmt::format("'{}' must be a list of {} numbers", key, size));
    for (std::size_t i = 0; i < size; ++i) {
      value[static_cast<Eigen::Index>(i)] =
          static_cast<std::remove_reference_t<decltype(value[0])>>(bounded(node[i], key, limits));
    }
  }

  YAML::Node node_;
  std::string where_;
  std::set<std::string> known_;
};

class Writer {
 public:
  explicit Writer(YAML::Emitter& out) : out_(out) { out_ << YAML::BeginMap; }
  ~Writer() { out_ << YAML::EndMap; }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void text(const char* key, const std::string& value) { pair(key, value); }
  template <typename Number>
  void number(const char* key, Number value, Limits = {}) {
    pair(key, value);
  }
  void flag(const char* key, bool value) { pair(key, value); }
  template <typename Vector>
  void vector(const char* key, const Vector& value, Limits) {
    out_ << YAML::Key << key << YAML::Value;
    sequence(value);
  }
  template <typename Enum>
  void choice(const char* key, Enum value, const Names& names) {
    pair(key, names[static_cast<std::size_t>(value)]);
  }
  template <typename Struct>
  void block(const char* key, Struct& value) {
    out_ << YAML::Key << key << YAML::Value;
    Writer writer(out_);
    describe(writer, value);
  }
  template <typename Struct>
  void list(const char* key, std::vector<Struct>& values) {
    out_ << YAML::Key << key << YAML::Value << YAML::BeginSeq;
    for (Struct& value : values) {
      Writer writer(out_);
      describe(writer, value);
    }
    out_ << YAML::EndSeq;
  }
  void points(const char* key, const std::vector<Eigen::Vector2d>& values) {
    out_ << YAML::Key << key << YAML::Value << YAML::BeginSeq;
    for (const Eigen::Vector2d& value : values) sequence(value);
    out_ << YAML::EndSeq;
  }

 private:
  template <typename Value>
  void pair(const char* key, const Value& value) {
    out_ << YAML::Key << key << YAML::Value << value;
  }
  template <typename Vector>
  void sequence(const Vector& value) {
    out_ << YAML::Flow << YAML::BeginSeq;
    for (const auto element : value) out_ << element;
    out_ << YAML::EndSeq;
  }

  YAML::Emitter& out_;
};

template <typename Archive>
void describe(Archive& archive, Material& material) {
  archive.choice("pattern", material.pattern, pattern_names);
  archive.number("size_m", material.size_m, {0.005, 10});
  archive.vector("dark", material.dark, share);
  archive.vector("light", material.light, share);
}

template <typename Archive>
void describe(Archive& archive, ImageFormat& image) {
  archive.number("width", image.width, {16, largest_side});
  archive.number("height", image.height, {16, largest_side});
  archive.number("fps", image.fps, {0.1, 10000});
  archive.number("samples", image.samples, {1, 16});
  archive.flag("colour", image.colour);
}

template <typename Archive>
void describe(Archive& archive, Camera& camera) {
  archive.number("focal_px", camera.focal_px, {10, 10000});
  archive.vector("distortion", camera.distortion, {-1, 1});
  archive.number("forward_m", camera.forward_m, {-2, 2});
  archive.number("height_m", camera.height_m, {0.02, 20});
  archive.number("pitch_deg", camera.pitch_deg, {-90, 90});
  archive.number("roll_deg", camera.roll_deg, {-90, 90});
}

template <typename Archive>
void describe(Archive& archive, Sensor& sensor) {
  archive.number("full_well_e", sensor.full_well_e, {10, 1e7});
  archive.number("read_noise_e", sensor.read_noise_e, {0, 1e4});
  archive.number("exposure_drift", sensor.exposure_drift, {0, 0.2});
}

template <typename Archive>
void describe(Archive& archive, Light& light) {
  archive.vector("position", light.position, anywhere);
  archive.number("size_m", light.size_m, {0, 100});
  archive.number("ambient", light.ambient, share);
}

template <typename Archive>
void describe(Archive& archive, Room& room) {
  archive.vector("low", room.low, anywhere);
  archive.vector("high", room.high, anywhere);
  archive.number("height_m", room.height_m, {0.1, 100});
  archive.number("skirting_m", room.skirting_m, {0, 1});
  archive.block("floor", room.floor);
  archive.block("wall", room.wall);
  archive.block("skirting", room.skirting);
}

template <typename Archive>
void describe(Archive& archive, ObstacleShape& shape) {
  archive.choice("kind", shape.kind, kind_names);
  archive.vector("position", shape.position, anywhere);
  archive.number("yaw_deg", shape.yaw_deg, angle);
  archive.vector("size", shape.size, {0.001, 100});
  archive.number("leg_m", shape.leg_m, {0.001, 1});
  archive.block("material", shape.material);
}

template <typename Archive>
void describe(Archive& archive, Marking& marking) {
  archive.points("polygon", marking.polygon);
  archive.block("material", marking.material);
}

template <typename Archive>
void describe(Archive& archive, PathSegment& segment) {
  archive.number("frames", segment.frames, {1, 100000});
  archive.number("step_m", segment.step_m, {-10, 10});
  archive.number("turn_deg", segment.turn_deg, angle);
}

template <typename Archive>
void describe(Archive& archive, Path& path) {
  archive.vector("start", path.start, anywhere);
  archive.number("heading_deg", path.heading_deg, angle);
  archive.number("sway_deg", path.sway_deg, {0, 10});
  archive.list("segments", path.segments);
}

template <typename Archive>
void describe(Archive& archive, OdometryNoise& odometry) {
  archive.number("distance", odometry.distance, share);
  archive.number("turn_deg", odometry.turn_deg, {0, 90});
  archive.number("scale", odometry.scale, {-0.5, 0.5});
  archive.number("slip_probability", odometry.slip_probability, share);
  archive.number("slip_share", odometry.slip_share, {0, 10});
}

template <typename Archive>
void describe(Archive& archive, Scene& scene) {
  archive.text("name", scene.name);
  archive.number("seed", scene.seed);
  archive.block("image", scene.image);
  archive.block("camera", scene.camera);
  archive.block("sensor", scene.sensor);
  archive.block("light", scene.light);
  archive.block("room", scene.room);
  archive.list("obstacles", scene.obstacles);
  archive.list("markings", scene.markings);
  archive.block("path", scene.path);
  archive.block("odometry", scene.odometry);
}

bool is_convex(const std::vector<Eigen::Vector2d>& polygon) {
  const auto turn = [&](std::size_t i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2d& c = polygon[(i + 2) % polygon.size()];
    return (b - a).x() * (c - b).y() - (b - a).y() * (c - b).x();
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (turn(i) * turn(0) <= 0) return false;
  }
  return true;
}

// What no single key can tell.
void check(const Scene& scene, const std::string& name) {
  const auto require = [&](bool good, const char* what) {
    if (!good) throw Error(fmt::format("{}: {}.", name, what));
  };
  require((scene.room.low.array() < scene.room.high.array()).all(),
          "room.low must be below room.high in x and y");
  require(scene.obstacles.size() <= 200, "a scene holds at most 200 obstacles; drop some");
  require(!scene.path.segments.empty(), "path.segments needs at least one segment");
  require(scene.path.segments.size() <= 10000, "a path has at most 10000 segments; join some");
  require(scene.frame_count() <= 100000, "a path has at most 100000 frames; shorten its segments");
  for (const Marking& marking : scene.markings) {
    require(marking.polygon.size() >= 3 && is_convex(marking.polygon),
            "each marking needs a convex polygon; split the others");
  }
}

}  // namespace

int Scene::frame_count() const {
  int count = 0;
  for (const PathSegment& segment : path.segments) count += segment.frames;
  return count;
}

Scene parse_scene(const std::string& yaml, const std::string& name) {
  YAML::Node root;
  try {
    root = YAML::Load(yaml);
  } catch (const YAML::Exception& error) {
    throw Error(fmt::format("{}:{}: this is no YAML: {}.", name, error.mark.line + 1, error.msg));
  }
  Scene scene;
  Reader::read_into(root, name, scene);
  check(scene, name);
  return scene;
}

Scene read_scene(const std::filesystem::path& file) { return parse_scene(read_text(file), file.string()); }

std::string scene_to_yaml(const Scene& scene) {
  YAML::Emitter out;
  out.SetDoublePrecision(17);
  out.SetFloatPrecision(9);
  {
    Scene copy = scene;  // describe works on mutable structs; it only reads this one
    Writer writer(out);
    describe(writer, copy);
  }
  return std::string(out.c_str()) + "\n";
}

}  // namespace floorline::render
