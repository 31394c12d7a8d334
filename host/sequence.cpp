#include "host/sequence.h"

#include <utility>

#include "host/image_file.h"
#include "host/mount.h"
#include "host/yaml_file.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

std::string frame_name(int frame) { return fmt::format("{:06}.png", frame); }

void require_camera_size(const cv::Mat& image, const Camera& camera, const std::string& name) {
  if (image.size() == camera.size) return;
  throw Error(
      fmt::format("{}: is {}x{} while the calibration is for {}x{}; use the calibration of these images.",
                  name, image.cols, image.rows, camera.size.width, camera.size.height));
}

}  // namespace

Sequence::Sequence(fs::path folder) : folder_(std::move(folder)) {
  const YamlFile yaml(folder_ / "sequence.yaml");
  info_ = {yaml.get<std::string>("name"), yaml.get<double>("fps"), yaml.get<std::string>("source")};
  has_truth_ = yaml.get<bool>("has_truth");
  camera_ = read_camera(folder_ / "camera.yaml");
  if (camera_.size != cv::Size(yaml.get<int>("width"), yaml.get<int>("height"))) {
    yaml.refuse("width and height differ from those of camera.yaml");
  }
  robot_from_camera_ = read_mount(folder_ / "mount.yaml");
  odometry_ = read_odometry(folder_ / "odometry.csv");
  const int due = yaml.get<int>("frame_count");
  if (due < 1) yaml.refuse("frame_count must be at least 1");
  if (due != frame_count())
    yaml.refuse(fmt::format("frame_count is {} but odometry.csv has {} frames", due, frame_count()));
  first_frame_ = read_image(folder_ / "frames" / frame_name(0));
  require_camera_size(first_frame_, camera_, (folder_ / "frames" / frame_name(0)).string());
}

std::vector<Eigen::Isometry3d> Sequence::world_from_robot(PoseSource source) const {
  if (source == PoseSource::odometry) {
    std::vector<Eigen::Isometry3d> poses;
    for (const OdometrySample& sample : odometry_) poses.push_back(isometry(sample.pose));
    return poses;
  }
  const fs::path file = folder_ / "poses.txt";
  if (!fs::exists(file))
    throw Error(fmt::format("{}: is not there; use the odometry instead.", file.string()));
  std::vector<Eigen::Isometry3d> poses = read_kitti_poses(file);
  if (poses.size() != odometry_.size()) {
    throw Error(fmt::format("{}: has {} poses for {} frames; give one a frame.", file.string(), poses.size(),
                            frame_count()));
  }
  return poses;
}

cv::Mat Sequence::frame(int frame) const {
  if (frame == 0) return first_frame_;
  const fs::path file = folder_ / "frames" / frame_name(frame);
  cv::Mat image = read_image(file);
  require_same_format(image, first_frame_, file.string());
  return image;
}

std::optional<fs::path> Sequence::truth_folder() const {
  return has_truth_ ? std::optional(folder_ / "truth") : std::nullopt;
}

cv::Mat Sequence::truth_mask(int frame) const {
  const fs::path file = folder_ / "truth" / "masks" / frame_name(frame);
  cv::Mat mask = read_image(file);
  require_camera_size(mask, camera_, file.string());
  return mask;
}

SequenceWriter::SequenceWriter(const fs::path& folder, SequenceInfo info, Camera camera,
                               const Eigen::Isometry3d& robot_from_camera)
    : staging_(folder), info_(std::move(info)), camera_(std::move(camera)) {
  fs::create_directories(staging_.path() / "frames");
  write_camera(camera_, staging_.path() / "camera.yaml");
  write_mount(robot_from_camera, staging_.path() / "mount.yaml");
}

void SequenceWriter::add(const SequenceFrame& frame) {
  const auto index = static_cast<int>(odometry_.size());
  const std::string name = fmt::format("frame {}", index);
  require_camera_size(frame.image, camera_, name);
  if (index == 0) first_frame_ = frame.image.clone();
  require_same_format(frame.image, first_frame_, name);
  write_image(staging_.path() / "frames" / frame_name(index), frame.image);
  if (!frame.truth_mask.empty()) {
    has_truth_ = true;
    fs::create_directories(staging_.path() / "truth" / "masks");
    write_image(staging_.path() / "truth" / "masks" / frame_name(index), frame.truth_mask);
  }
  odometry_.push_back(frame.odometry);
  if (frame.world_from_robot) poses_.push_back(*frame.world_from_robot);
}

void SequenceWriter::finish() {
  write_odometry(odometry_, staging_.path() / "odometry.csv");
  if (!poses_.empty()) write_kitti_poses(poses_, staging_.path() / "poses.txt");
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "name" << YAML::Value << info_.name;
  yaml << YAML::Key << "width" << YAML::Value << camera_.size.width;
  yaml << YAML::Key << "height" << YAML::Value << camera_.size.height;
  yaml << YAML::Key << "frame_count" << YAML::Value << odometry_.size();
  yaml << YAML::Key << "fps" << YAML::Value << info_.fps;
  yaml << YAML::Key << "source" << YAML::Value << info_.source;
  yaml << YAML::Key << "has_truth" << YAML::Value << has_truth_;
  yaml << YAML::EndMap;
  write_file(staging_.path() / "sequence.yaml", std::string(yaml.c_str()) + "\n");
  staging_.commit();
}

}  // namespace floorline
