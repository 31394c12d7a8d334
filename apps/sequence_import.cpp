#include "sequence_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "host/atomic_file.h"
#include "host/error.h"
#include "host/mount.h"
#include "host/text_file.h"
#include "render/truth.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

cv::Mat read_image(const fs::path& file) {
  const cv::Mat image = cv::imread(file.string(), cv::IMREAD_ANYCOLOR);
  if (image.empty()) throw Error(fmt::format("{}: is missing, truncated or no image.", file.string()));
  return image;
}

/// Image files of a folder, sorted by name.
std::vector<fs::path> list_images(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw Error(fmt::format("{}: is no folder; give the folder of the recording.", folder.string()));
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (cv::haveImageReader(entry.path().string())) files.push_back(entry.path());
  }
  if (files.empty()) throw Error(fmt::format("{}: holds no image that can be read.", folder.string()));
  std::sort(files.begin(), files.end());
  return files;
}

const fs::path& required(const std::optional<fs::path>& file, const char* option, const char* what) {
  if (!file) throw Error(fmt::format("this recording does not say {}; give {} FILE.", what, option));
  return *file;
}

const fs::path& camera_file(const ImportFiles& files) {
  return required(files.camera, "--camera", "how the camera is calibrated");
}
const fs::path& mount_file(const ImportFiles& files) {
  return required(files.mount, "--mount", "how the camera is mounted");
}
const fs::path& odometry_file(const ImportFiles& files) {
  return required(files.odometry, "--odometry", "how the robot moved");
}

void require_same_count(std::size_t frames, std::size_t entries, const fs::path& file) {
  if (frames == entries) return;
  throw Error(
      fmt::format("{}: has {} entries for {} images; each frame needs one.", file.string(), entries, frames));
}

/// The folder's own name, whether or not the path ends in a slash.
std::string name_of(const fs::path& path) {
  return fs::absolute(path / "").parent_path().filename().stem().string();
}

/// The first four-number matrix line that begins with `key`, from KITTI's calib.txt.
Camera kitti_camera(const fs::path& file, cv::Size size) {
  const std::string text = read_text(file);
  for (const std::string_view line : split(text, '\n')) {
    double fx = 0, skew = 0, cx = 0, t = 0, zero = 0, fy = 0, cy = 0;
    if (std::sscanf(std::string(line).c_str(), "P0: %lf %lf %lf %lf %lf %lf %lf", &fx, &skew, &cx, &t, &zero,
                    &fy, &cy) != 7)
      continue;
    Camera camera{.size = size};
    camera.matrix << fx, 0, cx, 0, fy, cy, 0, 0, 1;
    if (camera.matrix.allFinite() && fx > 0 && fy > 0) return camera;
  }
  throw Error(
      fmt::format("{}: has no usable line 'P0: ...' with the left camera's projection.", file.string()));
}

/// The mount from plane.txt.
Eigen::Isometry3d kitti_mount(const fs::path& file) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double height = 0;
  const std::string text = read_text(file);
  for (const std::string_view line : split(text, '\n')) {
    std::sscanf(std::string(line).c_str(), "n %lf %lf %lf", &normal.x(), &normal.y(), &normal.z());
    std::sscanf(std::string(line).c_str(), "h_m %lf", &height);
  }
  if (normal.isZero() || height <= 0)
    throw Error(fmt::format("{}: needs the lines 'n X Y Z' and 'h_m H'.", file.string()));
  return robot_from_camera(mount_from_plane(normal, height));
}

std::vector<double> kitti_times(const fs::path& file, std::size_t frames) {
  std::vector<double> times;
  if (!fs::exists(file)) {
    for (std::size_t i = 0; i < frames; ++i) times.push_back(static_cast<double>(i) / 10.0);
    return times;
  }
  for (const NumberRow& row : read_numbers(file, ' ', 1)) times.push_back(row.values[0]);
  require_same_count(frames, times.size(), file);
  return times;
}

/// Camera poses become robot poses in the frame of the robot at the first of them.
void set_poses(Recording& recording, const std::vector<Eigen::Isometry3d>& world_from_camera,
               const std::vector<double>& times) {
  const Eigen::Isometry3d first_from_world =
      recording.robot_from_camera * world_from_camera.front().inverse();
  for (std::size_t i = 0; i < world_from_camera.size(); ++i) {
    recording.poses.push_back(first_from_world * world_from_camera[i] *
                              recording.robot_from_camera.inverse());
    recording.odometry.push_back({times[i], planar(recording.poses.back())});
  }
}

void set_image_files(Recording& recording, std::vector<fs::path> images) {
  recording.image = [images = std::move(images)](std::size_t frame) { return read_image(images.at(frame)); };
}

/// Frames that can only be read one after the other.
void set_video(Recording& recording, const fs::path& file) {
  auto video = std::make_shared<cv::VideoCapture>(file.string());
  if (!video->isOpened()) throw Error(fmt::format("{}: is no video that OpenCV can read.", file.string()));
  recording.image = [video, file, frames = recording.odometry.size()](std::size_t frame) {
    cv::Mat image;
    if (!video->read(image))
      throw Error(
          fmt::format("{}: ends after {} frames, but the odometry has {}.", file.string(), frame, frames));
    return image;
  };
}

/// Camera, mount and odometry from their files.
Recording open_files(const ImportFiles& files, const fs::path& source, const char* kind) {
  Recording recording{.name = name_of(source), .source = kind};
  recording.camera = read_camera(camera_file(files));
  recording.robot_from_camera = read_mount(mount_file(files));
  recording.odometry = read_odometry(odometry_file(files));
  return recording;
}

/// KITTI's mask in the values of truth/masks.
cv::Mat truth_mask(const cv::Mat& mask) {
  cv::Mat values(mask.size(), CV_8UC1, cv::Scalar(render::MaskValue::unknown));
  values.setTo(render::MaskValue::floor, mask == 128);
  values.setTo(render::MaskValue::first_obstacle, mask == 255);
  return values;
}

void require_size(const cv::Mat& image, const Camera& camera, std::size_t frame) {
  if (image.size() == camera.size) return;
  throw Error(fmt::format(
      "frame {} is {} x {} pixels, but the camera has {} x {}; all frames must have the camera's size.",
      frame, image.cols, image.rows, camera.size.width, camera.size.height));
}

void write_descriptions(const Recording& recording, const fs::path& folder) {
  write_camera(recording.camera, folder / "camera.yaml");
  write_mount(recording.robot_from_camera, folder / "mount.yaml");
  write_odometry(recording.odometry, folder / "odometry.csv");
  if (!recording.poses.empty()) write_kitti_poses(recording.poses, folder / "poses.txt");
  const std::size_t frames = recording.odometry.size();
  const double seconds = recording.odometry.back().timestamp_s - recording.odometry.front().timestamp_s;
  const double fps = frames > 1 ? static_cast<double>(frames - 1) / seconds : 1.0;
  write_file(folder / "sequence.yaml",
             fmt::format(
                 "name: {}\nwidth: {}\nheight: {}\nframe_count: {}\nfps: {:.6g}\nsource: {}\nhas_truth: {}\n",
                 recording.name, recording.camera.size.width, recording.camera.size.height, frames, fps,
                 recording.source, !recording.truth_masks.empty()));
}

}  // namespace

Recording open_kitti(const fs::path& folder, const ImportFiles& files) {
  const std::vector<fs::path> images = list_images(folder / "image_0");
  Recording recording{.name = name_of(folder), .source = "kitti"};
  recording.camera = files.camera ? read_camera(*files.camera)
                                  : kitti_camera(folder / "calib.txt", read_image(images[0]).size());
  recording.robot_from_camera = files.mount ? read_mount(*files.mount) : kitti_mount(folder / "plane.txt");
  const std::vector<Eigen::Isometry3d> poses = read_kitti_poses(folder / "poses.txt");
  require_same_count(images.size(), poses.size(), folder / "poses.txt");
  set_poses(recording, poses, kitti_times(folder / "times.txt", images.size()));
  if (fs::exists(folder / "gt_mask")) {
    recording.truth_masks = list_images(folder / "gt_mask");
    require_same_count(images.size(), recording.truth_masks.size(), folder / "gt_mask");
  }
  set_image_files(recording, images);
  return recording;
}

Recording open_images(const fs::path& folder, const ImportFiles& files) {
  const std::vector<fs::path> images = list_images(folder);
  Recording recording = open_files(files, folder, "images");
  require_same_count(images.size(), recording.odometry.size(), *files.odometry);
  set_image_files(recording, images);
  return recording;
}

Recording open_tum(const fs::path& folder, const ImportFiles& files) {
  constexpr double longest_gap_s = 0.1;
  const std::vector<fs::path> images = list_images(folder / "rgb");
  const std::vector<StampedPose> trajectory = read_tum_trajectory(folder / "groundtruth.txt");
  std::vector<Eigen::Isometry3d> poses;
  std::vector<double> times;
  for (const fs::path& image : images) {
    const double time = std::strtod(image.stem().c_str(), nullptr);
    if (time <= 0)
      throw Error(fmt::format("{}: must be named after its timestamp in seconds.", image.string()));
    times.push_back(time);
    poses.push_back(pose_at(trajectory, time, longest_gap_s));
  }
  Recording recording{.name = name_of(folder), .source = "tum"};
  recording.camera = read_camera(camera_file(files));
  const Eigen::Isometry3d floor_from_robot = isometry(planar(poses.front()));
  recording.robot_from_camera =
      files.mount ? read_mount(*files.mount) : floor_from_robot.inverse() * poses.front();
  set_poses(recording, poses, times);
  set_image_files(recording, images);
  return recording;
}

Recording open_video(const fs::path& file, const ImportFiles& files) {
  Recording recording = open_files(files, file, "video");
  set_video(recording, file);
  return recording;
}

void write_sequence(const Recording& recording, const fs::path& folder,
                    const std::function<void(int)>& progress) {
  StagedFolder staged(folder);
  const std::size_t frames = recording.odometry.size();
  fs::create_directories(staged.path() / "frames");
  if (!recording.truth_masks.empty()) fs::create_directories(staged.path() / "truth/masks");
  for (std::size_t i = 0; i < frames; ++i) {
    const std::string name = fmt::format("{:06}.png", i);
    const cv::Mat image = recording.image(i);
    require_size(image, recording.camera, i);
    write_image(staged.path() / "frames" / name, image);
    if (!recording.truth_masks.empty())
      write_image(staged.path() / "truth/masks" / name, truth_mask(read_image(recording.truth_masks[i])));
    progress(static_cast<int>(i + 1));
  }
  write_descriptions(recording, staged.path());
  staged.commit();
}

}  // namespace floorline::app
