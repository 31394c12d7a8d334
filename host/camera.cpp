#include "host/camera.h"

#include <algorithm>

#include "host/atomic_file.h"
#include "host/yaml_file.h"

namespace floorline {

Camera read_camera(const std::filesystem::path& file) {
  const YamlFile yaml(file);
  Camera camera;
  camera.size = {yaml.get<int>("image_width"), yaml.get<int>("image_height")};
  if (std::min(camera.size.width, camera.size.height) < 1 ||
      std::max(camera.size.width, camera.size.height) > largest_side) {
    yaml.refuse(fmt::format("image_width and image_height must lie between 1 and {}", largest_side));
  }

  const std::vector<double> matrix = yaml.numbers("camera_matrix");
  if (matrix.size() != 9) yaml.refuse("'camera_matrix' must have nine numbers");
  camera.matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix.data());
  const Eigen::Matrix3d& k = camera.matrix;
  if (!(k(0, 0) > 0 && k(1, 1) > 0)) yaml.refuse("'camera_matrix' needs positive focal lengths");
  if (!k.row(2).isApprox(Eigen::RowVector3d::UnitZ()) || k(1, 0) != 0 || k(0, 1) != 0) {
    yaml.refuse("'camera_matrix' must be fx 0 cx, 0 fy cy, 0 0 1");
  }

  if (yaml.has("distortion_model") && yaml.get<std::string>("distortion_model") != "plumb_bob") {
    yaml.refuse("the distortion model is not plumb_bob, so calibrate with that one");
  }
  const std::vector<double> distortion = yaml.numbers("distortion_coefficients");
  if (distortion.size() > camera.distortion.size()) {
    yaml.refuse("'distortion_coefficients' has more than k1 k2 p1 p2 k3, so calibrate with these");
  }
  std::ranges::copy(distortion, camera.distortion.begin());
  return camera;
}

void write_camera(const Camera& camera, const std::filesystem::path& file) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> matrix = camera.matrix;
  cv::FileStorage out(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  out << "image_width" << camera.size.width << "image_height" << camera.size.height;
  out << "camera_matrix" << cv::Mat(cv::Matx33d(matrix.data()));
  out << "distortion_coefficients" << cv::Mat(cv::Matx<double, 1, 5>(camera.distortion.data()));
  write_file(file, out.releaseAndGetString());
}

}  // namespace floorline
