#include "world.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <tuple>

#include "geometry.h"
#include "lens.h"
#include "noise.h"
#include "texture.h"

namespace floorline::render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int packet = 8;             // rays that Embree traces at once
constexpr float lift = 1e-3f;         // start of shadow rays off the surface, metres
constexpr float lens_blur_px = 0.5f;  // standard deviation of the lens' point spread
constexpr double contact_step_m = 0.01;
constexpr int floor_texels = 1024;
constexpr int other_texels = 256;

struct Hit {
  const Mesh* mesh;
  const Texture* texture;
  Vector3f position;
  Vector3f normal;
  Vector2f surface;
  Footprint footprint;
};

// How surface coordinates grow along the two edges that leave a triangle's first vertex.
Vector2f surface_direction(const Mesh& mesh, const Mesh::Triangle& triangle, const Vector3f& direction) {
  const auto &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
             &c = mesh.vertices[triangle[2]];
  const Vector3f e1 = b.position - a.position, e2 = c.position - a.position;
  const float g11 = e1.dot(e1), g12 = e1.dot(e2), g22 = e2.dot(e2);
  const float r1 = e1.dot(direction), r2 = e2.dot(direction);
  const float determinant = g11 * g22 - g12 * g12;
  const float w1 = (g22 * r1 - g12 * r2) / determinant, w2 = (g11 * r2 - g12 * r1) / determinant;
  return w1 * (b.surface - a.surface) + w2 * (c.surface - a.surface);
}

// The value that most samples of a pixel have.
std::uint8_t majority(const std::uint8_t* values, int count) {
  int best = 0, best_votes = 0;
  for (int i = 0; i < count; ++i) {
    const auto votes = static_cast<int>(std::count(values, values + count, values[i]));
    if (votes > best_votes) {
      best = i;
      best_votes = votes;
    }
    if (2 * votes > count) break;
  }
  return values[best];
}

// Cuts a run of points into its visible pieces, at gaps too. A round foot may start anywhere: an end that
// meets the first piece belongs to it.
std::vector<Polyline> visible_pieces(const Polyline& points, const std::vector<bool>& visible) {
  std::vector<Polyline> pieces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!visible[i]) continue;
    const bool goes_on = i > 0 && visible[i - 1] && (points[i] - points[i - 1]).norm() < 2 * contact_step_m;
    if (!goes_on) pieces.emplace_back();
    pieces.back().push_back(points[i]);
  }
  if (pieces.size() > 1 && (pieces.back().back() - pieces.front().front()).norm() < 2 * contact_step_m) {
    pieces.back().insert(pieces.back().end(), pieces.front().begin(), pieces.front().end());
    pieces.front() = std::move(pieces.back());
    pieces.pop_back();
  }
  return pieces;
}

double length(const std::vector<Polyline>& pieces) {
  double sum = 0;
  for (const Polyline& piece : pieces) {
    for (std::size_t i = 1; i < piece.size(); ++i) sum += (piece[i] - piece[i - 1]).norm();
  }
  return sum;
}

// Of a foot: what the camera sees of it, and the length of the sides that face it.
struct VisibleFoot {
  std::vector<Polyline> pieces;
  double facing_length = 0;
};

const char* name_of(ObstacleKind kind) {
  switch (kind) {
    case ObstacleKind::box:
      return "box";
    case ObstacleKind::cylinder:
      return "cylinder";
    case ObstacleKind::chair:
      return "chair";
    case ObstacleKind::table:
      return "table";
    case ObstacleKind::person:
      return "person";
    case ObstacleKind::ramp:
      return "ramp";
  }
  return "";
}

}  // namespace

struct World::Tracer {
  explicit Tracer(const Scene& scene_in)
      : scene(scene_in), meshes(build_meshes(scene)), lens(scene.image, scene.camera) {
    for (const Mesh& mesh : meshes) {
      const int texels = mesh.mask_value == MaskValue::floor ? floor_texels : other_texels;
      textures.push_back(texture_of(mesh.material, texels));
    }
    device = rtcNewDevice(nullptr);
    accelerator = rtcNewScene(device);
    rtcSetSceneFlags(accelerator, RTC_SCENE_FLAG_ROBUST);
    for (const Mesh& mesh : meshes) attach(mesh);
    rtcCommitScene(accelerator);
    const int samples = scene.image.samples;
    for (int i = 0; i < samples; ++i) {
      const Vector2f offset = sample_offset(i, samples) * static_cast<float>(scene.light.size_m);
      lamp.emplace_back(scene.light.position.cast<float>() + Vector3f(offset.x(), offset.y(), 0));
    }
  }
  ~Tracer() {
    rtcReleaseScene(accelerator);
    rtcReleaseDevice(device);
  }
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // Surfaces of one pattern and size share a texture: baking costs more than a frame.
  const Texture* texture_of(const Material& material, int texels) {
    std::unique_ptr<Texture>& texture = baked[{material.pattern, material.size_m, texels}];
    if (!texture)
      texture = std::make_unique<Texture>(material.pattern, material.size_m, mix(scene.seed), texels);
    return texture.get();
  }

  void attach(const Mesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    for (const Mesh::Vertex& vertex : mesh.vertices)
      positions = std::copy_n(vertex.position.data(), 3, positions);
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const Mesh::Triangle& triangle : mesh.triangles) indices = std::copy_n(triangle.data(), 3, indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(accelerator, geometry);
    rtcReleaseGeometry(geometry);
  }

  // Radiance of the pixels [column, column + packet) of one row for sample s.
  void trace(const Eigen::Isometry3f& pose, int row, int column, int s, Vector3f* radiance,
             std::uint8_t* masks) const;
  std::optional<Hit> hit_of(const RTCRayHit8& rays, int lane, const Vector3f& origin) const;
  Vector3f albedo(const Hit& hit) const;
  bool sees(const Eigen::Isometry3d& world_from_camera, const Vector2d& floor_point) const;
  VisibleFoot visible_foot(const Eigen::Isometry3d& world_from_camera, const Polyline& foot,
                           double in_front_m) const;

  Scene scene;
  std::vector<Mesh> meshes;
  std::vector<const Texture*> textures;  // one a mesh
  std::map<std::tuple<Pattern, double, int>, std::unique_ptr<Texture>> baked;
  LensRays lens;
  std::vector<Vector3f> lamp;  // a point of it for each sample of a pixel
  RTCDevice device;
  RTCScene accelerator;
};

std::optional<Hit> World::Tracer::hit_of(const RTCRayHit8& rays, int lane, const Vector3f& origin) const {
  const unsigned id = rays.hit.geomID[lane];
  if (id == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Mesh& mesh = meshes[id];
  const Mesh::Triangle& triangle = mesh.triangles[rays.hit.primID[lane]];
  const auto &a = mesh.vertices[triangle[0]], &b = mesh.vertices[triangle[1]],
             &c = mesh.vertices[triangle[2]];
  const float wb = rays.hit.u[lane], wc = rays.hit.v[lane], wa = 1 - wb - wc;
  const Vector3f direction(rays.ray.dir_x[lane], rays.ray.dir_y[lane], rays.ray.dir_z[lane]);
  Hit hit{&mesh,
          textures[id],
          origin + direction * rays.ray.tfar[lane],
          (wa * a.normal + wb * b.normal + wc * c.normal).normalized(),
          wa * a.surface + wb * b.surface + wc * c.surface,
          {}};
  // A pixel's cone cuts the surface in an ellipse, stretched by 1 / cos along the view. The samples of a
  // pixel share it: along the view, which is mostly up and down the image, each has a row of its own.
  const auto samples = static_cast<float>(scene.image.samples);
  const Vector3f view = direction.normalized();
  const float cosine = std::max(std::abs(view.dot(hit.normal)), 0.02f);
  const float radius = lens.pixel_angle() / 2 * (hit.position - origin).norm() / std::sqrt(samples);
  const float stretched = std::max(radius, radius / cosine / std::sqrt(samples));
  const Vector3f along = (view - view.dot(hit.normal) * hit.normal).normalized();
  hit.footprint = {surface_direction(mesh, triangle, along) * stretched, radius};
  return hit;
}

Vector3f World::Tracer::albedo(const Hit& hit) const {
  const float value = hit.texture->sample(hit.surface, hit.footprint);
  return hit.mesh->material.dark + value * (hit.mesh->material.light - hit.mesh->material.dark);
}

void World::Tracer::trace(const Eigen::Isometry3f& pose, int row, int column, int s, Vector3f* radiance,
                          std::uint8_t* masks) const {
  const int count = std::min(packet, scene.image.width - column);
  alignas(32) std::array<int, packet> valid;
  alignas(32) RTCRayHit8 rays;
  const Vector3f origin = pose.translation();
  for (int lane = 0; lane < packet; ++lane) {
    valid[lane] = lane < count ? -1 : 0;
    const Vector3f direction =
        pose.linear() * lens.ray(row, std::min(column + lane, scene.image.width - 1), s);
    rays.ray.org_x[lane] = origin.x(), rays.ray.org_y[lane] = origin.y(), rays.ray.org_z[lane] = origin.z();
    rays.ray.dir_x[lane] = direction.x(), rays.ray.dir_y[lane] = direction.y(),
    rays.ray.dir_z[lane] = direction.z();
    rays.ray.tnear[lane] = 0, rays.ray.tfar[lane] = INFINITY, rays.ray.time[lane] = 0;
    rays.ray.mask[lane] = ~0u, rays.ray.id[lane] = 0, rays.ray.flags[lane] = 0;
    rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid.data(), accelerator, &context, &rays);

  std::array<std::optional<Hit>, packet> hits;
  alignas(32) RTCRay8 shadow = rays.ray;
  for (int lane = 0; lane < count; ++lane) {
    hits[lane] = hit_of(rays, lane, origin);
    valid[lane] = hits[lane] ? -1 : 0;
    if (!hits[lane]) continue;
    const Vector3f start = hits[lane]->position + hits[lane]->normal * lift;
    const Vector3f path = lamp[s] - start;
    shadow.org_x[lane] = start.x(), shadow.org_y[lane] = start.y(), shadow.org_z[lane] = start.z();
    shadow.dir_x[lane] = path.x(), shadow.dir_y[lane] = path.y(), shadow.dir_z[lane] = path.z();
    shadow.tnear[lane] = 0, shadow.tfar[lane] = 1;
  }
  rtcOccluded8(valid.data(), accelerator, &context, &shadow);

  const float ambient = static_cast<float>(scene.light.ambient);
  for (int lane = 0; lane < count; ++lane) {
    if (!hits[lane]) {
      radiance[lane].setZero();
      masks[lane] = MaskValue::wall;
      continue;
    }
    const Hit& hit = *hits[lane];
    const Vector3f path = lamp[s] - hit.position;
    const float distance = path.norm();
    const float falloff = lamp[s].z() / distance;
    const bool lit = shadow.tfar[lane] >= 0;  // Embree sets it to -infinity where something is in between
    const float direct = lit ? std::max(0.0f, hit.normal.dot(path) / distance) * falloff * falloff : 0.0f;
    radiance[lane] = albedo(hit) * (ambient + (1 - ambient) * direct);
    masks[lane] = static_cast<std::uint8_t>(hit.mesh->mask_value);
  }
}

// Whether nothing stands between the lens and a floor point inside the image.
bool World::Tracer::sees(const Eigen::Isometry3d& world_from_camera, const Vector2d& floor_point) const {
  const Vector3d target(floor_point.x(), floor_point.y(), lift);
  if (!lens.in_image(world_from_camera.inverse() * target)) return false;
  const Vector3f origin = world_from_camera.translation().cast<float>();
  const Vector3f path = target.cast<float>() - origin;
  RTCRay ray{};
  ray.org_x = origin.x(), ray.org_y = origin.y(), ray.org_z = origin.z();
  ray.dir_x = path.x(), ray.dir_y = path.y(), ray.dir_z = path.z();
  ray.tfar = 1;
  ray.mask = ~0u;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(accelerator, &context, &ray);
  return ray.tfar >= 0;
}

VisibleFoot World::Tracer::visible_foot(const Eigen::Isometry3d& world_from_camera, const Polyline& foot,
                                        double in_front_m) const {
  const Vector2d eye = world_from_camera.translation().head<2>();
  VisibleFoot result;
  Polyline points;
  std::vector<bool> visible;
  const std::size_t edges = foot.size() == 2 ? 1 : foot.size();
  for (std::size_t i = 0; i < edges; ++i) {
    const Vector2d &a = foot[i], &b = foot[(i + 1) % foot.size()];
    const Vector2d along = (b - a).normalized();
    const Vector2d front = (edges == 1 ? -1 : 1) * Vector2d(along.y(), -along.x());
    if (front.dot(eye - a) <= 0) continue;
    result.facing_length += (b - a).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / contact_step_m)));
    for (int k = 0; k <= steps; ++k) {
      points.push_back(a + (b - a) * (static_cast<double>(k) / steps));
      visible.push_back(sees(world_from_camera, points.back() + front * in_front_m));
    }
  }
  result.pieces = visible_pieces(points, visible);
  return result;
}

World::World(const Scene& scene) : tracer_(std::make_unique<Tracer>(scene)) {}
World::~World() = default;

View World::view(const Eigen::Isometry3d& world_from_camera) const {
  const ImageFormat& image = tracer_->scene.image;
  const Eigen::Isometry3f pose = world_from_camera.cast<float>();
  View view{cv::Mat(image.height, image.width, CV_32FC3), cv::Mat(image.height, image.width, CV_8U)};
  tbb::parallel_for(0, image.height, [&](int row) {
    for (int column = 0; column < image.width; column += packet) {
      std::array<Vector3f, packet> sum, radiance;
      std::array<std::array<std::uint8_t, packet>, 16> masks;
      sum.fill(Vector3f::Zero());
      for (int s = 0; s < image.samples; ++s) {
        tracer_->trace(pose, row, column, s, radiance.data(), masks[s].data());
        for (int lane = 0; lane < packet; ++lane) sum[lane] += radiance[lane];
      }
      for (int lane = 0; lane < std::min(packet, image.width - column); ++lane) {
        const Vector3f mean = sum[lane] / static_cast<float>(image.samples);
        view.radiance.at<cv::Vec3f>(row, column + lane) = {mean.z(), mean.y(), mean.x()};
        std::array<std::uint8_t, 16> votes;
        for (int s = 0; s < image.samples; ++s) votes[s] = masks[s][lane];
        view.mask.at<std::uint8_t>(row, column + lane) = majority(votes.data(), image.samples);
      }
    }
  });
  cv::GaussianBlur(view.radiance, view.radiance, {3, 3}, lens_blur_px);
  return view;
}

TrueFrame World::truth(const TrajectoryFrame& frame, const Eigen::Isometry3d& world_from_camera,
                       const cv::Mat& mask) const {
  const Scene& scene = tracer_->scene;
  const Eigen::Rotation2Dd unturn(-frame.exact.yaw);
  const auto to_robot = [&](std::vector<Polyline> pieces) {
    for (Polyline& piece : pieces) {
      for (Vector2d& point : piece) point = unturn * (point - frame.exact.position);
    }
    return pieces;
  };
  std::array<int, 256> pixels{};
  for (const std::uint8_t value : cv::Mat_<std::uint8_t>(mask)) ++pixels[value];

  TrueFrame truth;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const int visible_pixels = pixels[MaskValue::first_obstacle + i];
    if (visible_pixels == 0) continue;
    const ObstacleShape& shape = scene.obstacles[i];
    TrueObstacle obstacle{static_cast<int>(i), name_of(shape.kind), shape.size.z(), visible_pixels, 0, {}};
    double facing = 0;
    for (const Polyline& foot : footprints(shape)) {
      const VisibleFoot seen = tracer_->visible_foot(world_from_camera, foot, 0.003);
      facing += seen.facing_length;
      obstacle.contact.insert(obstacle.contact.end(), seen.pieces.begin(), seen.pieces.end());
    }
    obstacle.contact_share = std::min(1.0, length(obstacle.contact) / facing);
    obstacle.contact = to_robot(obstacle.contact);
    truth.obstacles.push_back(std::move(obstacle));
  }
  for (const Polyline& foot : wall_feet(scene.room)) {
    constexpr double before_skirting_m = 0.015;
    const auto pieces = to_robot(tracer_->visible_foot(world_from_camera, foot, before_skirting_m).pieces);
    truth.walls.insert(truth.walls.end(), pieces.begin(), pieces.end());
  }
  for (const Marking& marking : scene.markings) truth.markings.push_back(to_robot({marking.polygon})[0]);
  return truth;
}

}  // namespace floorline::render
