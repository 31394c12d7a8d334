/// A calibrated camera and its file.
#ifndef FLOORLINE_HOST_CAMERA_H
#define FLOORLINE_HOST_CAMERA_H

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <opencv2/core.hpp>

namespace floorline {

/// Of an image, pixels: what the sizes of hls/types.h and the reach of its lines allow.
constexpr int largest_side = 2047;

/// Pinhole with lens distortion. Camera frame: x right, y down, z forward; pixel centres at whole numbers.
struct Camera {
  cv::Size size;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();  ///< K, pixels.
  std::array<double, 5> distortion{};                    ///< k1 k2 p1 p2 k3, as OpenCV.

  bool distorted() const { return distortion != std::array<double, 5>{}; }
};

/// Reads an OpenCV calibration file or a ROS camera_info file (YAML); both name image_width, image_height,
/// camera_matrix and distortion_coefficients. Throws Error when a key is missing, a number is not finite, the
/// focal length is not positive, or the distortion model is another than plumb_bob.
Camera read_camera(const std::filesystem::path& file);

/// Writes an OpenCV calibration file.
void write_camera(const Camera& camera, const std::filesystem::path& file);

}  // namespace floorline

#endif
