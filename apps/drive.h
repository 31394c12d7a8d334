/// A sequence frame by frame, with everything that both models need.
#ifndef FLOORLINE_APPS_DRIVE_H
#define FLOORLINE_APPS_DRIVE_H

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/parameters.h"
#include "host/sequence.h"

namespace floorline::app {

/// The options of every command that runs a model.
class DriveOptions {
 public:
  void add_to(CLI::App& parser);

  /// Throws Error like read_settings().
  Settings settings() const;
  PoseSource poses() const { return poses_ == "exact" ? PoseSource::poses : PoseSource::odometry; }

 private:
  std::string file_;
  std::string rule_;
  std::string poses_ = "odometry";
  std::optional<int> baseline_;
};

/// One frame as it goes into the models.
struct DriveFrame {
  int index;
  double timestamp_s;
  cv::Mat image;  ///< As it comes from the sequence; rectified and grey when the camera has distortion.
  Eigen::Isometry3d world_from_robot;
  PlannedFrame plan;
  golden::Parameters golden;
  FrameParameters kernel;
};

class Drive {
 public:
  /// Throws Error for everything that Sequence and Configuration refuse.
  Drive(const std::filesystem::path& sequence_folder, const Settings& settings, PoseSource poses);

  const Sequence& sequence() const { return sequence_; }
  const Configuration& configuration() const { return configuration_; }
  const std::vector<Eigen::Isometry3d>& world_from_robot() const { return world_from_robot_; }
  int frame_count() const { return sequence_.frame_count(); }

  /// Frames must be asked for in order, from 0 on: the reference plan goes on with each.
  DriveFrame next();

 private:
  Sequence sequence_;
  Configuration configuration_;
  std::vector<Eigen::Isometry3d> world_from_robot_;
  ReferencePlan plan_;
  std::optional<golden::Lens> lens_;
  int next_ = 0;
};

}  // namespace floorline::app

#endif
