#include "host/sequence.h"

#include "host/text_file.h"
#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

namespace fs = std::filesystem;

constexpr int frame_count = 3;

cv::Mat grey(int level) { return cv::Mat(480, 640, CV_8UC1, cv::Scalar(level)); }

SequenceFrame frame_of(int index) {
  return {.image = grey(10 * index),
          .odometry = {0.1 * index, {0.05 * index, 0, 0}},
          .world_from_robot = isometry({0.051 * index, 0, 0}),
          .truth_mask = grey(index)};
}

/// A good sequence in folder/sequence.
fs::path write_sequence(const TemporaryFolder& folder) {
  SequenceWriter writer(folder / "sequence", {"walk", 10, "a test"}, test_camera(),
                        robot_from_camera(test_angles));
  for (int i = 0; i < frame_count; ++i) writer.add(frame_of(i));
  writer.finish();
  return folder / "sequence";
}

/// Replaces a part of one of the sequence's files and opens it.
void open_with(const fs::path& sequence, const std::string& file, const std::string& part,
               const std::string& replacement) {
  std::string text = read_text(sequence / file);
  text.replace(text.find(part), part.size(), replacement);
  write_text(sequence / file, text);
  Sequence{sequence};
}

TEST(Sequence, IsWrittenAndReadBack) {
  const TemporaryFolder folder;
  const Sequence sequence(write_sequence(folder));
  EXPECT_EQ(sequence.info().name, "walk");
  EXPECT_EQ(sequence.info().fps, 10);
  EXPECT_EQ(sequence.info().source, "a test");
  EXPECT_EQ(sequence.frame_count(), frame_count);
  EXPECT_EQ(sequence.camera().matrix, test_camera().matrix);
  EXPECT_TRUE(sequence.robot_from_camera().isApprox(robot_from_camera(test_angles), 1e-9));
  EXPECT_NEAR(sequence.timestamp_s(2), 0.2, 1e-9);
  EXPECT_EQ(sequence.frame(0).at<uchar>(3, 4), 0);
  EXPECT_EQ(sequence.frame(2).at<uchar>(3, 4), 20);
  EXPECT_EQ(sequence.truth_mask(1).at<uchar>(3, 4), 1);
  EXPECT_EQ(sequence.truth_folder(), folder / "sequence/truth");
}

TEST(Sequence, OffersOdometryAndFullPoses) {
  const TemporaryFolder folder;
  const Sequence sequence(write_sequence(folder));
  EXPECT_NEAR(sequence.world_from_robot(PoseSource::odometry)[2].translation().x(), 0.1, 1e-9);
  EXPECT_NEAR(sequence.world_from_robot(PoseSource::poses)[2].translation().x(), 0.102, 1e-9);
  write_text(folder / "sequence/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_REFUSED(sequence.world_from_robot(PoseSource::poses), "has 1 poses for 3 frames");
  fs::remove(folder / "sequence/poses.txt");
  EXPECT_REFUSED(sequence.world_from_robot(PoseSource::poses), "use the odometry instead");
}

TEST(Sequence, WithoutTruthHasNone) {
  const TemporaryFolder folder;
  SequenceWriter writer(folder / "sequence", {"walk", 10, "a test"}, test_camera(),
                        robot_from_camera(test_angles));
  writer.add({.image = grey(1), .odometry = {}, .world_from_robot = {}, .truth_mask = {}});
  writer.finish();
  EXPECT_EQ(Sequence(folder / "sequence").truth_folder(), std::nullopt);
}

TEST(Sequence, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  EXPECT_REFUSED(Sequence(folder / "none"), "sequence.yaml: cannot be read");
  const auto refused = [&](const std::string& file, const std::string& part, const std::string& replacement,
                           const std::string& sentence) {
    fs::remove_all(folder / "sequence");
    const fs::path sequence = write_sequence(folder);
    EXPECT_REFUSED(open_with(sequence, file, part, replacement), sentence);
  };
  refused("sequence.yaml", "frame_count: 3", "frame_count: 4",
          "frame_count is 4 but odometry.csv has 3 frames");
  refused("sequence.yaml", "frame_count: 3", "frame_count: 0", "must be at least 1");
  refused("sequence.yaml", "width: 640", "width: 641", "differ from those of camera.yaml");
  refused("sequence.yaml", "fps: 10", "fps: fast", "'fps' has a value of the wrong kind");
  refused("odometry.csv", "\n1,", "\n2,", "frame 1 is missing");
}

TEST(Sequence, RefusesImagesThatDoNotFit) {
  const TemporaryFolder folder;
  const fs::path path = write_sequence(folder);
  write_image(path / "frames/000001.png", cv::Mat(480, 640, CV_8UC3, cv::Scalar(1, 2, 3)));
  write_image(path / "frames/000002.png", cv::Mat(480, 600, CV_8UC1, cv::Scalar(1)));
  write_image(path / "truth/masks/000000.png", cv::Mat(48, 60, CV_8UC1, cv::Scalar(1)));
  const Sequence sequence(path);
  EXPECT_REFUSED(sequence.frame(1), "000001.png: is in colour while the images before are grey");
  EXPECT_REFUSED(sequence.frame(2), "000002.png: is 600x480");
  EXPECT_REFUSED(sequence.truth_mask(0), "use the calibration of these images");
  fs::remove(path / "frames/000001.png");
  EXPECT_REFUSED(sequence.frame(1), "000001.png: cannot be read");
  write_image(path / "frames/000000.png", cv::Mat(48, 60, CV_8UC1, cv::Scalar(1)));
  EXPECT_REFUSED(Sequence{path}, "is 60x48 while the calibration is for 640x480");
}

TEST(SequenceWriter, LeavesNothingWhenItIsNotFinished) {
  const TemporaryFolder folder;
  {
    SequenceWriter writer(folder / "sequence", {"walk", 10, "a test"}, test_camera(),
                          robot_from_camera(test_angles));
    writer.add(frame_of(0));
    SequenceFrame colour = frame_of(1);
    colour.image = cv::Mat(480, 640, CV_8UC3, cv::Scalar(1, 2, 3));
    EXPECT_REFUSED(writer.add(colour), "frame 1: is in colour");
    SequenceFrame small = frame_of(1);
    small.image = cv::Mat(48, 64, CV_8UC1, cv::Scalar(1));
    EXPECT_REFUSED(writer.add(small), "frame 1: is 64x48");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace floorline
