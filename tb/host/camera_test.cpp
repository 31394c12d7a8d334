#include "host/camera.h"

#include "test_files.h"

namespace floorline {
namespace {

const std::string ros = R"(image_width: 640
image_height: 480
camera_name: front
camera_matrix:
  rows: 3
  cols: 3
  data: [420.5, 0, 319.5, 0, 421, 239.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.2, 0.05, 0.001, -0.002, 0]
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
)";

std::string with(std::string text, const std::string& part, const std::string& replacement) {
  return text.replace(text.find(part), part.size(), replacement);
}

Camera read(const TemporaryFolder& folder, const std::string& text) {
  write_text(folder / "camera.yaml", text);
  return read_camera(folder / "camera.yaml");
}

TEST(Camera, ReadsRosCameraInfo) {
  const Camera camera = read(TemporaryFolder(), ros);
  EXPECT_EQ(camera.size, cv::Size(640, 480));
  EXPECT_EQ(camera.matrix(0, 0), 420.5);
  EXPECT_EQ(camera.matrix(1, 2), 239.5);
  EXPECT_EQ(camera.distortion, (std::array<double, 5>{-0.2, 0.05, 0.001, -0.002, 0}));
  EXPECT_TRUE(camera.distorted());
}

TEST(Camera, ReadsWhatOpenCvAndItselfWrite) {
  const TemporaryFolder folder;
  const Camera camera = read(folder, ros);
  write_camera(camera, folder / "ours.yaml");
  const Camera ours = read_camera(folder / "ours.yaml");
  EXPECT_EQ(ours.matrix, camera.matrix);
  EXPECT_EQ(ours.distortion, camera.distortion);

  cv::FileStorage opencv((folder / "opencv.yaml").string(), cv::FileStorage::WRITE);
  opencv << "image_width" << 320 << "image_height" << 200;
  opencv << "camera_matrix" << cv::Mat(cv::Matx33d(200, 0, 160, 0, 200, 100, 0, 0, 1));
  opencv << "distortion_coefficients" << cv::Mat::zeros(4, 1, CV_64F);
  opencv.release();
  const Camera theirs = read_camera(folder / "opencv.yaml");
  EXPECT_EQ(theirs.size, cv::Size(320, 200));
  EXPECT_EQ(theirs.matrix(0, 2), 160);
  EXPECT_FALSE(theirs.distorted());
}

TEST(Camera, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  EXPECT_REFUSED(read_camera(folder / "none.yaml"), "cannot be read");
  EXPECT_REFUSED(read(folder, ""), "there are no keys");
  EXPECT_REFUSED(read(folder, "a: [1, 2\nb: }"), "is no YAML");
  EXPECT_REFUSED(read(folder, with(ros, "image_width: 640", "")), "'image_width' is missing");
  EXPECT_REFUSED(read(folder, with(ros, "640", "wide")), "'image_width' has a value of the wrong kind");
  EXPECT_REFUSED(read(folder, with(ros, "640", "0")), "must lie between 1 and");
  EXPECT_REFUSED(read(folder, with(ros, "640", "100000")), "must lie between 1 and");
  EXPECT_REFUSED(read(folder, with(ros, ", 0, 0, 1]", "]")), "must have nine numbers");
  EXPECT_REFUSED(read(folder, with(ros, "420.5", "-420.5")), "positive focal lengths");
  EXPECT_REFUSED(read(folder, with(ros, "420.5", ".nan")), "not finite");
  EXPECT_REFUSED(read(folder, with(ros, "420.5", "f")), "is no list of numbers");
  EXPECT_REFUSED(read(folder, with(ros, "420.5, 0", "420.5, 3")), "must be fx 0 cx");
  EXPECT_REFUSED(read(folder, with(ros, "plumb_bob", "equidistant")), "not plumb_bob");
  EXPECT_REFUSED(read(folder, with(ros, "-0.002, 0]", "-0.002, 0, 0.1]")), "more than k1 k2 p1 p2 k3");
}

}  // namespace
}  // namespace floorline
