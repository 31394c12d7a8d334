#include "host/import.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "host/atomic_file.h"
#include "host/sequence.h"
#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

constexpr int frame_count = 3;
const cv::Size size(64, 48);

Camera small_camera() {
  Camera camera;
  camera.size = size;
  camera.matrix << 40, 0, 31.5, 0, 40, 23.5, 0, 0, 1;
  return camera;
}

cv::Mat picture(int index, int type = CV_8UC1) {
  return cv::Mat(size, type, cv::Scalar::all(50 + 10 * index));
}

Companions write_companions(const TemporaryFolder& folder, int frames = frame_count) {
  write_camera(small_camera(), folder / "camera.yaml");
  write_mount(robot_from_camera(test_angles), folder / "mount.yaml");
  std::vector<OdometrySample> odometry;
  for (int i = 0; i < frames; ++i) odometry.push_back({0.25 * i, {0.1 * i, 0, 0}});
  write_odometry(odometry, folder / "odometry.csv");
  return {folder / "camera.yaml", folder / "mount.yaml", folder / "odometry.csv"};
}

void write_pictures(const fs::path& folder, int type = CV_8UC1) {
  fs::create_directories(folder);
  for (int i = 0; i < frame_count; ++i)
    cv::imwrite((folder / fmt::format("{:02}.png", i)).string(), picture(i, type));
}

TEST(ImportImages, MakesASequence) {
  const TemporaryFolder folder;
  write_pictures(folder / "images");
  std::vector<int> steps;
  import_images(folder / "images", write_companions(folder), folder / "out", [&](int done, int total) {
    EXPECT_EQ(total, frame_count);
    steps.push_back(done);
    return true;
  });
  EXPECT_THAT(steps, testing::ElementsAre(1, 2, 3));
  const Sequence sequence(folder / "out");
  EXPECT_EQ(sequence.frame_count(), frame_count);
  EXPECT_EQ(sequence.info().name, "out");
  EXPECT_EQ(sequence.info().fps, 4);
  EXPECT_EQ(sequence.frame(2).at<uchar>(0, 0), 70);
  EXPECT_NEAR(sequence.world_from_robot(PoseSource::odometry)[2].translation().x(), 0.2, 1e-9);
}

TEST(ImportImages, StoppedLeavesNothing) {
  const TemporaryFolder folder;
  write_pictures(folder / "images");
  const Companions companions = write_companions(folder);
  EXPECT_REFUSED(import_images(folder / "images", companions, folder / "out", [](int, int) { return false; }),
                 "was stopped");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ImportImages, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  write_pictures(folder / "images");
  EXPECT_REFUSED(import_images(folder / "none", write_companions(folder), folder / "out"),
                 "holds no PNG or JPEG");
  EXPECT_REFUSED(import_images(folder / "images", write_companions(folder, 2), folder / "out"),
                 "ends after 2 frames");
  EXPECT_REFUSED(import_images(folder / "images", write_companions(folder, 4), folder / "out"),
                 "has 3 images but");
  const Companions companions = write_companions(folder);
  cv::imwrite((folder / "images/01.png").string(), picture(1, CV_8UC3));
  EXPECT_REFUSED(import_images(folder / "images", companions, folder / "out"), "frame 1: is in colour");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ImportVideo, MakesASequence) {
  const TemporaryFolder folder;
  const std::string file = (folder / "clip.avi").string();
  cv::VideoWriter video(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 4, size);
  ASSERT_TRUE(video.isOpened());
  for (int i = 0; i < frame_count; ++i) video.write(picture(i, CV_8UC3));
  video.release();
  import_video(file, write_companions(folder), folder / "out");
  const Sequence sequence(folder / "out");
  EXPECT_EQ(sequence.frame_count(), frame_count);
  ASSERT_EQ(sequence.frame(1).type(), CV_8UC3);
  EXPECT_NEAR(sequence.frame(1).at<cv::Vec3b>(20, 20)[0], 60, 3);
}

TEST(ImportVideo, RefusesWhatIsNoVideo) {
  const TemporaryFolder folder;
  write_text(folder / "clip.avi", "no video");
  EXPECT_REFUSED(import_video(folder / "clip.avi", write_companions(folder), folder / "out"), "is no video");
}

/// A KITTI drive straight ahead over a road 1.5 m below the camera.
void write_kitti(const fs::path& folder, int type = CV_8UC1) {
  write_pictures(folder / "image_0", type);
  fs::create_directories(folder / "gt_mask");
  cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
  mask.at<uchar>(40, 1) = 128;
  mask.at<uchar>(40, 2) = 255;
  cv::imwrite((folder / "gt_mask/01.png").string(), mask);
  write_text(folder / "calib.txt", "P0: 40 0 31.5 0 0 40 23.5 0 0 0 1 0\n");
  write_text(folder / "plane.txt", "# normal\nn 0 1 0\nh_m 1.5\n");
  write_text(folder / "poses.txt",
             "1 0 0 0 0 1 0 0 0 0 1 0\n"
             "1 0 0 0 0 1 0 0 0 0 1 1\n"
             "1 0 0 0 0 1 0 0 0 0 1 2\n");
}

TEST(ImportKitti, MakesASequence) {
  const TemporaryFolder folder;
  write_kitti(folder / "drive");
  import_kitti(folder / "drive", folder / "out");
  const Sequence sequence(folder / "out");
  EXPECT_EQ(sequence.camera().matrix, small_camera().matrix);
  EXPECT_NEAR(sequence.robot_from_camera().translation().z(), 1.5, 1e-9);
  for (const PoseSource source : {PoseSource::odometry, PoseSource::poses}) {
    const auto poses = sequence.world_from_robot(source);
    EXPECT_TRUE(poses[0].isApprox(Eigen::Isometry3d::Identity(), 1e-9));
    EXPECT_TRUE(poses[2].translation().isApprox(Eigen::Vector3d(2, 0, 0), 1e-9)) << "forward is X";
  }
  const cv::Mat mask = sequence.truth_mask(1);
  EXPECT_EQ(mask.at<uchar>(40, 0), 255);
  EXPECT_EQ(mask.at<uchar>(40, 1), 0);
  EXPECT_EQ(mask.at<uchar>(40, 2), 16);
}

TEST(ImportKitti, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  write_kitti(folder / "drive", CV_8UC3);
  EXPECT_REFUSED(import_kitti(folder / "drive", folder / "out"), "is in colour where grey is due");
  write_kitti(folder / "drive");
  write_text(folder / "drive/plane.txt", "n 0 1\nh_m 1.5\n");
  EXPECT_REFUSED(import_kitti(folder / "drive", folder / "out"),
                 "plane.txt: needs a line 'n' with 3 finite numbers");
  write_text(folder / "drive/plane.txt", "n 0 1 nan\nh_m 1.5\n");
  EXPECT_REFUSED(import_kitti(folder / "drive", folder / "out"), "3 finite numbers");
  write_kitti(folder / "drive");
  write_text(folder / "drive/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_REFUSED(import_kitti(folder / "drive", folder / "out"), "has 3 images but");
  write_kitti(folder / "drive");
  write_text(folder / "drive/image_0/01.png", "no image");
  EXPECT_REFUSED(import_kitti(folder / "drive", folder / "out"), "01.png: is no image");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ImportTum, MakesASequenceOfRealData) {
  SKIP_WITHOUT_SHARED_DATA("tum_fr1_rpy");
  const TemporaryFolder folder;
  Camera camera = test_camera();
  camera.matrix << 517.3, 0, 318.6, 0, 516.5, 255.3, 0, 0, 1;
  write_camera(camera, folder / "camera.yaml");
  import_tum(shared_data("tum_fr1_rpy"), folder / "camera.yaml", folder / "out");
  const Sequence sequence(folder / "out");
  EXPECT_EQ(sequence.frame_count(), 8);
  EXPECT_NEAR(sequence.info().fps, 30, 2);
  EXPECT_NEAR(sequence.robot_from_camera().translation().z(), 1.49, 0.02)
      << "height of the camera in groundtruth.txt";
  EXPECT_EQ(sequence.frame(7).type(), CV_8UC3);
}

TEST(ImportTum, RefusesImagesWithoutATimestampOrPose) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "drive/rgb");
  write_camera(small_camera(), folder / "camera.yaml");
  write_text(folder / "drive/groundtruth.txt", "1 0 0 1 0.5 -0.5 0.5 -0.5\n1.01 0 0 1 0.5 -0.5 0.5 -0.5\n");
  cv::imwrite((folder / "drive/rgb/first.png").string(), picture(0));
  EXPECT_REFUSED(import_tum(folder / "drive", folder / "camera.yaml", folder / "out"),
                 "the name is no timestamp");
  fs::rename(folder / "drive/rgb/first.png", folder / "drive/rgb/7.5.png");
  EXPECT_REFUSED(import_tum(folder / "drive", folder / "camera.yaml", folder / "out"),
                 "does not reach 7.500 s");
}

}  // namespace
}  // namespace floorline
