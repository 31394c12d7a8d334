/// Makes sequence folders of other people's data.
#ifndef FLOORLINE_HOST_IMPORT_H
#define FLOORLINE_HOST_IMPORT_H

#include <filesystem>
#include <functional>

namespace floorline {

/// Called after each frame with the number of frames done and of all frames (0: not known); returns false to
/// stop.
using ImportProgress = std::function<bool(int done, int total)>;

/// All of these write the sequence folder `destination`, which appears only when it is complete, and throw
/// Error with one sentence when it is there already, when an input is missing, malformed or does not fit the
/// rest, or when `progress` stopped them.

/// A KITTI drive: image_0/ (grey, rectified), calib.txt (P0), poses.txt (camera to world), plane.txt (the
/// mean floor plane: "n nx ny nz" pointing down and "h_m height", camera frame), and gt_mask/ where there is
/// one (0 unknown, 128 floor, 255 obstacle). The robot is the point of the floor under the camera of frame 0;
/// its planar odometry is cut out of the full poses.
void import_kitti(const std::filesystem::path& source, const std::filesystem::path& destination,
                  const ImportProgress& progress = {});

/// What goes with images that are nothing but images.
struct Companions {
  std::filesystem::path camera;    ///< camera.yaml or ROS camera_info.
  std::filesystem::path mount;     ///< mount.yaml.
  std::filesystem::path odometry;  ///< odometry.csv, a line a frame.
};

/// A folder of PNG or JPEG images, in the order of their names.
void import_images(const std::filesystem::path& folder, const Companions& companions,
                   const std::filesystem::path& destination, const ImportProgress& progress = {});

/// A video file.
void import_video(const std::filesystem::path& file, const Companions& companions,
                  const std::filesystem::path& destination, const ImportProgress& progress = {});

/// A TUM RGB-D drive: rgb/TIMESTAMP.png and groundtruth.txt (camera to world, Z up, the floor at Z = 0). The
/// robot is the point of the floor under the camera of the first image; full poses tilt with the camera.
void import_tum(const std::filesystem::path& source, const std::filesystem::path& camera,
                const std::filesystem::path& destination, const ImportProgress& progress = {});

}  // namespace floorline

#endif
