#include "host/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/image_file.h"
#include "host/mount.h"
#include "host/sequence.h"
#include "host/text_file.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

constexpr double kitti_fps = 10;
/// TUM's motion capture runs at 100 Hz; a gap of more than this loses the camera.
constexpr double tum_longest_gap_s = 0.1;

void report(const ImportProgress& progress, int done, int total) {
  if (progress && !progress(done, total)) throw Error("The import was stopped; nothing was written.");
}

void require_one_each(const fs::path& images, std::size_t image_count, const fs::path& poses,
                      std::size_t pose_count) {
  if (image_count == pose_count) return;
  throw Error(fmt::format("{} has {} images but {} has {} lines; give one line an image.", images.string(),
                          image_count, poses.string(), pose_count));
}

/// The numbers after `key` on the line of a text file that begins with it.
std::vector<double> numbers_after(const fs::path& file, std::string_view key, std::size_t count) {
  const std::string text = read_text(file);
  for (std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> fields = split(line, ' ');
    if (fields.empty() || fields.front() != key || fields.size() < count + 1) continue;
    std::vector<double> numbers;
    for (std::size_t i = 1; i <= count; ++i) numbers.push_back(finite_number(fields[i]).value_or(NAN));
    if (std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); })) return numbers;
  }
  throw Error(fmt::format("{}: needs a line '{}' with {} finite numbers; correct the file.", file.string(),
                          key, count));
}

Camera kitti_camera(const fs::path& file, cv::Size size) {
  const std::vector<double> p = numbers_after(file, "P0:", 12);
  Camera camera;
  camera.size = size;
  camera.matrix << p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10];
  return camera;
}

Eigen::Isometry3d kitti_mount(const fs::path& file) {
  const std::vector<double> normal = numbers_after(file, "n", 3);
  const double height_m = numbers_after(file, "h_m", 1)[0];
  return robot_from_camera(mount_from_plane({normal[0], normal[1], normal[2]}, height_m));
}

/// gt_mask to the values of truth/masks.
cv::Mat kitti_truth(const fs::path& file) {
  constexpr int floor = 0, obstacle = 16, unknown = 255;
  cv::Mat values(1, 256, CV_8U, cv::Scalar(unknown));
  values.at<uchar>(128) = floor;
  values.at<uchar>(255) = obstacle;
  cv::Mat mask;
  cv::LUT(read_image(file), values, mask);
  return mask;
}

/// Poses of the robot in the frame in which it starts, from those of the camera in some world.
std::vector<Eigen::Isometry3d> robot_poses(const std::vector<Eigen::Isometry3d>& world_from_camera,
                                           const Eigen::Isometry3d& robot_from_camera) {
  std::vector<Eigen::Isometry3d> poses;
  const Eigen::Isometry3d first = robot_from_camera * world_from_camera.at(0).inverse();
  for (const Eigen::Isometry3d& pose : world_from_camera)
    poses.push_back(first * pose * robot_from_camera.inverse());
  return poses;
}

/// The mount of a camera that looks over the floor Z = 0 of its world: the robot stands under it and heads
/// where it looks.
Eigen::Isometry3d mount_over_floor(const Eigen::Isometry3d& world_from_camera) {
  const Eigen::Vector3d down = world_from_camera.linear().transpose() * -Eigen::Vector3d::UnitZ();
  return robot_from_camera(mount_from_plane(down, world_from_camera.translation().z()));
}

/// Writes images that come with files for everything else; `next` gives an empty image at the end.
void import_with_companions(const std::string& source, const Companions& companions,
                            const fs::path& destination, int total, const ImportProgress& progress,
                            const std::function<cv::Mat()>& next) {
  const std::vector<OdometrySample> odometry = read_odometry(companions.odometry);
  const Eigen::Isometry3d mount = read_mount(companions.mount);
  const double span_s = odometry.empty() ? 0 : odometry.back().timestamp_s - odometry.front().timestamp_s;
  const double fps = span_s > 0 ? (odometry.size() - 1) / span_s : 0;
  SequenceWriter writer(destination, {destination.stem().string(), fps, source},
                        read_camera(companions.camera), mount);
  std::size_t done = 0;
  for (cv::Mat image = next(); !image.empty(); image = next()) {
    if (done == odometry.size()) {
      throw Error(fmt::format("{}: ends after {} frames but there are more images; give a line for each.",
                              companions.odometry.string(), done));
    }
    writer.add({.image = image, .odometry = odometry[done], .world_from_robot = {}, .truth_mask = {}});
    report(progress, static_cast<int>(++done), total);
  }
  require_one_each(source, done, companions.odometry, odometry.size());
  writer.finish();
}

}  // namespace

void import_kitti(const fs::path& source, const fs::path& destination, const ImportProgress& progress) {
  const std::vector<fs::path> images = image_files(source / "image_0");
  const Camera camera = kitti_camera(source / "calib.txt", read_image(images.front()).size());
  const Eigen::Isometry3d mount = kitti_mount(source / "plane.txt");
  const std::vector<Eigen::Isometry3d> camera_poses = read_kitti_poses(source / "poses.txt");
  require_one_each(source / "image_0", images.size(), source / "poses.txt", camera_poses.size());
  const std::vector<Eigen::Isometry3d> poses = robot_poses(camera_poses, mount);

  SequenceWriter writer(destination, {destination.stem().string(), kitti_fps, "KITTI"}, camera, mount);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const cv::Mat image = read_image(images[i]);
    if (image.channels() != 1) {
      throw Error(fmt::format("{}: is in colour where grey is due; give the folder of the grey camera.",
                              images[i].string()));
    }
    const fs::path truth = source / "gt_mask" / images[i].filename();
    writer.add({.image = image,
                .odometry = {static_cast<double>(i) / kitti_fps, planar(poses[i])},
                .world_from_robot = poses[i],
                .truth_mask = fs::exists(truth) ? kitti_truth(truth) : cv::Mat()});
    report(progress, static_cast<int>(i) + 1, static_cast<int>(images.size()));
  }
  writer.finish();
}

void import_images(const fs::path& folder, const Companions& companions, const fs::path& destination,
                   const ImportProgress& progress) {
  const std::vector<fs::path> images = image_files(folder);
  std::size_t taken = 0;
  import_with_companions(folder.string(), companions, destination, static_cast<int>(images.size()), progress,
                         [&] { return taken < images.size() ? read_image(images[taken++]) : cv::Mat(); });
}

void import_video(const fs::path& file, const Companions& companions, const fs::path& destination,
                  const ImportProgress& progress) {
  cv::VideoCapture video(file.string());
  if (!video.isOpened())
    throw Error(
        fmt::format("{}: is no video that can be read; convert it, for example to MJPEG.", file.string()));
  const int total = std::max(0, static_cast<int>(video.get(cv::CAP_PROP_FRAME_COUNT)));
  import_with_companions(file.string(), companions, destination, total, progress, [&] {
    cv::Mat image;
    video.read(image);
    return image;
  });
}

void import_tum(const fs::path& source, const fs::path& camera, const fs::path& destination,
                const ImportProgress& progress) {
  const std::vector<fs::path> images = image_files(source / "rgb");
  const std::vector<StampedPose> trajectory = read_tum_trajectory(source / "groundtruth.txt");
  std::vector<double> timestamps;
  std::vector<Eigen::Isometry3d> camera_poses;
  for (const fs::path& image : images) {
    const std::optional<double> timestamp = finite_number(image.stem().string());
    if (!timestamp)
      throw Error(fmt::format("{}: the name is no timestamp; name the images by their time in seconds.",
                              image.string()));
    timestamps.push_back(*timestamp);
    camera_poses.push_back(pose_at(trajectory, *timestamp, tum_longest_gap_s));
  }
  const Eigen::Isometry3d mount = mount_over_floor(camera_poses.front());
  const std::vector<Eigen::Isometry3d> poses = robot_poses(camera_poses, mount);

  const double span_s = timestamps.back() - timestamps.front();
  const double fps = span_s > 0 ? (timestamps.size() - 1) / span_s : 0;
  SequenceWriter writer(destination, {destination.stem().string(), fps, "TUM RGB-D"}, read_camera(camera),
                        mount);
  for (std::size_t i = 0; i < images.size(); ++i) {
    writer.add({.image = read_image(images[i]),
                .odometry = {timestamps[i], planar(poses[i])},
                .world_from_robot = poses[i],
                .truth_mask = {}});
    report(progress, static_cast<int>(i) + 1, static_cast<int>(images.size()));
  }
  writer.finish();
}

}  // namespace floorline
