#include "renderer.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "host/atomic_file.h"
#include "host/camera.h"
#include "host/error.h"
#include "noise.h"
#include "trajectory.h"
#include "world.h"

namespace floorline::render {
namespace {

namespace fs = std::filesystem;

constexpr double grey_target = 0.25;  // mean of the first frame, share of the full well
constexpr float gamma = 1 / 2.2f;     // of the camera's output

// Electrons with shot and read noise, then the output curve. Noise depends on seed, frame and pixel only.
cv::Mat expose(const cv::Mat& radiance, double exposure, const Sensor& sensor, std::uint64_t frame_seed) {
  cv::Mat image(radiance.size(), CV_8UC(radiance.channels()));
  const auto full = static_cast<float>(sensor.full_well_e);
  const auto read_variance = static_cast<float>(sensor.read_noise_e * sensor.read_noise_e);
  const int values = radiance.cols * radiance.channels();
  tbb::parallel_for(0, radiance.rows, [&](int row) {
    const float* in = radiance.ptr<float>(row);
    std::uint8_t* out = image.ptr<std::uint8_t>(row);
    Random random(frame_seed + static_cast<std::uint64_t>(row));
    for (int i = 0; i < values; ++i) {
      const float electrons = std::min(full, in[i] * static_cast<float>(exposure) * full);
      const float noise = std::sqrt(electrons + read_variance) * static_cast<float>(random.normal());
      const float level = std::clamp((electrons + noise) / full, 0.0f, 1.0f);
      out[i] = static_cast<std::uint8_t>(std::lround(255 * std::pow(level, gamma)));
    }
  });
  return image;
}

std::string pose_line(const Eigen::Isometry3d& pose) {
  std::string line;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) line += fmt::format("{:.9g} ", pose.matrix()(row, column));
  }
  line.back() = '\n';
  return line;
}

void write_camera(const Scene& scene, const fs::path& file) {
  const double f = scene.camera.focal_px;
  floorline::Camera camera;
  camera.size = {scene.image.width, scene.image.height};
  camera.matrix << f, 0, (camera.size.width - 1) / 2.0, 0, f, (camera.size.height - 1) / 2.0, 0, 0, 1;
  std::ranges::copy(scene.camera.distortion, camera.distortion.begin());
  floorline::write_camera(camera, file);
}

std::string mount_text(const Eigen::Isometry3d& mount) {
  std::string numbers;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      numbers += fmt::format("{:.9g}, ", mount.matrix()(row, column));
  }
  numbers.resize(numbers.size() - 2);
  return fmt::format("robot_from_camera: [{}]\n", numbers);
}

void write_descriptions(const Scene& scene, const std::vector<TrajectoryFrame>& trajectory,
                        const fs::path& folder) {
  write_camera(scene, folder / "camera.yaml");
  write_file(folder / "mount.yaml", mount_text(robot_from_camera(scene.camera)));
  std::string odometry = "frame,timestamp_s,x_m,y_m,yaw_rad\n", poses;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const PlanarPose& told = trajectory[i].odometry;
    odometry += fmt::format("{},{:.6f},{:.9g},{:.9g},{:.9g}\n", i, static_cast<double>(i) / scene.image.fps,
                            told.position.x(), told.position.y(), told.yaw);
    poses += pose_line(trajectory[i].world_from_robot);
  }
  write_file(folder / "odometry.csv", odometry);
  write_file(folder / "poses.txt", poses);
  write_file(folder / "scene.yaml", scene_to_yaml(scene));
  write_file(
      folder / "sequence.yaml",
      fmt::format(
          "name: {}\nwidth: {}\nheight: {}\nframe_count: {}\nfps: {}\nsource: rendered\nhas_truth: true\n",
          scene.name, scene.image.width, scene.image.height, scene.frame_count(), scene.image.fps));
}

void render_frames(const Scene& scene, const std::vector<TrajectoryFrame>& trajectory, const fs::path& folder,
                   const Progress& progress) {
  const World world(scene);
  const Eigen::Isometry3d mount = robot_from_camera(scene.camera);
  Random drift(scene.seed ^ 0x6472'6966'7400);
  std::vector<TrueFrame> truth;
  double exposure = 0;
  const int total = static_cast<int>(trajectory.size());
  for (int i = 0; i < total; ++i) {
    const TrajectoryFrame& frame = trajectory[static_cast<std::size_t>(i)];
    const Eigen::Isometry3d world_from_camera = frame.world_from_robot * mount;
    View view = world.view(world_from_camera);
    if (!scene.image.colour) cv::cvtColor(view.radiance, view.radiance, cv::COLOR_BGR2GRAY);
    exposure = i == 0 ? grey_target / std::max(1e-3, cv::mean(view.radiance)[0])
                      : exposure * (1 + scene.sensor.exposure_drift * drift.normal());
    const auto frame_seed = mix(mix(scene.seed) + static_cast<std::uint64_t>(i));
    const std::string name = fmt::format("{:06d}.png", i);
    write_image(folder / "frames" / name, expose(view.radiance, exposure, scene.sensor, frame_seed));
    write_image(folder / "truth/masks" / name, view.mask);
    truth.push_back(world.truth(frame, world_from_camera, view.mask));
    if (progress && !progress(i + 1, total)) {
      throw Error(fmt::format("{}: stopped after {} of {} frames.", scene.name, i + 1, total));
    }
  }
  write_truth(truth, folder / "truth/contacts.json");
}

}  // namespace

void render_sequence(const Scene& scene, const fs::path& folder, const Progress& progress) {
  StagedFolder staged(folder);
  fs::create_directories(staged.path() / "frames");
  fs::create_directories(staged.path() / "truth/masks");
  const std::vector<TrajectoryFrame> trajectory = plan_trajectory(scene);
  write_descriptions(scene, trajectory, staged.path());
  render_frames(scene, trajectory, staged.path(), progress);
  staged.commit();
}

}  // namespace floorline::render
