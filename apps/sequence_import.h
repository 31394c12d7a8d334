/// Foreign recordings as sequence folders (format: docs/architecture.md).
#ifndef FLOORLINE_APPS_SEQUENCE_IMPORT_H
#define FLOORLINE_APPS_SEQUENCE_IMPORT_H

#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/camera.h"
#include "host/odometry.h"

namespace floorline::app {

/// A recording before it becomes a sequence folder. Images come one at a time, in order.
struct Recording {
  std::string name;
  std::string source;  ///< For sequence.yaml, for example "kitti".
  Camera camera;
  Eigen::Isometry3d robot_from_camera;
  std::vector<OdometrySample> odometry;  ///< One a frame.
  std::vector<Eigen::Isometry3d> poses;  ///< Full poses of the robot, one a frame, or none.
  std::vector<std::filesystem::path>
      truth_masks;  ///< One a frame, or none: 128 floor, 255 obstacle, 0 unknown.
  std::function<cv::Mat(std::size_t frame)> image;  ///< CV_8UC1 or CV_8UC3.
};

/// What the files of a recording do not say.
struct ImportFiles {
  std::optional<std::filesystem::path> camera;    ///< OpenCV or ROS calibration.
  std::optional<std::filesystem::path> mount;     ///< mount.yaml.
  std::optional<std::filesystem::path> odometry;  ///< odometry.csv.
};

/// A KITTI odometry folder: image_0/, calib.txt, poses.txt (left camera), times.txt when it is there (10 Hz
/// otherwise), plane.txt
/// ("n X Y Z" and "h_m H": the floor in the camera frame) or else a mount file, gt_mask/ when it is there.
/// These readers throw Error with one sentence when something is missing or does not fit together.
Recording open_kitti(const std::filesystem::path& folder, const ImportFiles& files);

/// The image files of a folder in the order of their names.
Recording open_images(const std::filesystem::path& folder, const ImportFiles& files);

/// A TUM RGB-D folder: rgb/TIMESTAMP.png and groundtruth.txt (pose of the camera in a world whose Z points
/// up, floor at Z = 0). The mount is the camera's pose over the floor at the first frame.
Recording open_tum(const std::filesystem::path& folder, const ImportFiles& files);

/// A video file that OpenCV can read; frame i goes with line i of the odometry.
Recording open_video(const std::filesystem::path& file, const ImportFiles& files);

/// Writes the sequence folder. Throws Error when an image is missing, truncated or of another size than the
/// camera's, or when something cannot be written; nothing is left then. `progress` gets the number of frames
/// done.
void write_sequence(const Recording& recording, const std::filesystem::path& folder,
                    const std::function<void(int)>& progress);

}  // namespace floorline::app

#endif
