/// Sequence folders: images, calibration and odometry of one drive (format: docs/architecture.md).
#ifndef FLOORLINE_HOST_SEQUENCE_H
#define FLOORLINE_HOST_SEQUENCE_H

#include <Eigen/Geometry>
#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/atomic_file.h"
#include "host/camera.h"
#include "host/odometry.h"

namespace floorline {

/// sequence.yaml but for sizes and count.
struct SequenceInfo {
  std::string name;
  double fps = 10;
  std::string source;  ///< Where the images come from, in words.
};

/// Which poses of the robot to use.
enum class PoseSource {
  odometry,  ///< odometry.csv: planar, as the wheels tell.
  poses      ///< poses.txt: full and exact, where there is one.
};

class Sequence {
 public:
  /// Reads everything but the images. Throws Error with the first thing that is missing, malformed or does
  /// not fit the rest.
  explicit Sequence(std::filesystem::path folder);

  const SequenceInfo& info() const { return info_; }
  const Camera& camera() const { return camera_; }
  const Eigen::Isometry3d& robot_from_camera() const { return robot_from_camera_; }
  int frame_count() const { return static_cast<int>(odometry_.size()); }
  double timestamp_s(int frame) const { return odometry_.at(frame).timestamp_s; }

  /// world_from_robot of every frame. Throws Error when there is no poses.txt and it is asked for.
  std::vector<Eigen::Isometry3d> world_from_robot(PoseSource source) const;

  /// CV_8UC1, or CV_8UC3 (B G R), the same for all frames. Throws Error for a missing, truncated or differing
  /// image.
  cv::Mat frame(int frame) const;

  /// Folder of masks and contact curves, when the sequence has them.
  std::optional<std::filesystem::path> truth_folder() const;

  /// truth/masks of a frame, CV_8UC1; values in docs/architecture.md. Throws Error without it.
  cv::Mat truth_mask(int frame) const;

 private:
  std::filesystem::path folder_;
  SequenceInfo info_;
  bool has_truth_ = false;
  Camera camera_;
  Eigen::Isometry3d robot_from_camera_;
  std::vector<OdometrySample> odometry_;
  cv::Mat first_frame_;
};

/// One frame of a sequence that is being written.
struct SequenceFrame {
  cv::Mat image;
  OdometrySample odometry;
  std::optional<Eigen::Isometry3d> world_from_robot;  ///< Goes to poses.txt; all frames have it or none.
  cv::Mat truth_mask;                                 ///< Empty: none.
};

/// Writes a sequence folder, which appears when finish() is called.
class SequenceWriter {
 public:
  /// Throws Error when the folder is there already.
  SequenceWriter(const std::filesystem::path& folder, SequenceInfo info, Camera camera,
                 const Eigen::Isometry3d& robot_from_camera);

  /// Throws Error when the image is not of the camera's size or not of the kind of the first one, or cannot
  /// be written.
  void add(const SequenceFrame& frame);
  void finish();

 private:
  StagedFolder staging_;
  SequenceInfo info_;
  Camera camera_;
  std::vector<OdometrySample> odometry_;
  std::vector<Eigen::Isometry3d> poses_;
  bool has_truth_ = false;
  cv::Mat first_frame_;
};

}  // namespace floorline

#endif
