#include "host/odometry.h"

#include "test_files.h"

namespace floorline {
namespace {

const std::string header = "frame,timestamp_s,x_m,y_m,yaw_rad\n";

std::vector<OdometrySample> read(const TemporaryFolder& folder, const std::string& lines) {
  write_text(folder / "odometry.csv", header + lines);
  return read_odometry(folder / "odometry.csv");
}

TEST(PlanarPose, BecomesAnIsometryAndBack) {
  const PlanarPose pose = {1.5, -0.5, 2.0};
  const Eigen::Isometry3d full = isometry(pose);
  EXPECT_TRUE((full * Eigen::Vector3d(1, 0, 0))
                  .isApprox(Eigen::Vector3d(1.5 + std::cos(2.0), -0.5 + std::sin(2.0), 0)));
  EXPECT_NEAR(planar(full).yaw_rad, 2.0, 1e-12);
  EXPECT_EQ(planar(full).x_m, 1.5);
}

TEST(Odometry, IsWrittenAndReadBack) {
  const TemporaryFolder folder;
  write_odometry({{0, {0, 0, 0}}, {0.1, {0.05, -0.01, 0.02}}}, folder / "odometry.csv");
  const auto samples = read_odometry(folder / "odometry.csv");
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[1].timestamp_s, 0.1);
  EXPECT_EQ(samples[1].pose.x_m, 0.05);
  EXPECT_EQ(samples[1].pose.yaw_rad, 0.02);
}

TEST(Odometry, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  EXPECT_REFUSED(read(folder, "0,0,0,0,0\n2,0.2,0,0,0\n"), "odometry.csv:3: frame 1 is missing");
  EXPECT_REFUSED(read(folder, "0,0,0,0,0\n1,0.1,0,0,0\n1,0.2,0,0,0\n"), "frame 1 is out of order");
  EXPECT_REFUSED(read(folder, "0,0.5,0,0,0\n1,0.4,0,0,0\n"), "the timestamp does not grow");
  EXPECT_REFUSED(read(folder, "0,0,nan,0,0\n"), "'nan' is no finite number");
  EXPECT_REFUSED(read(folder, "0,0,0,0\n"), "4 numbers instead of 5");
  EXPECT_REFUSED(read(folder, "0,0,1e300,0,0\n"), "odometry.csv:2: the robot is farther than 1e+07 m");
  EXPECT_REFUSED(read(folder, "0,0,0,0,0\n1,0.1,500,0,0\n"), "odometry.csv:3: the robot jumps by 500 m");
  EXPECT_REFUSED(read(folder, "0,0,0,0,1e300\n"), "the yaw is no angle");
}

TEST(KittiPoses, AreWrittenAndReadBack) {
  const TemporaryFolder folder;
  const Eigen::Isometry3d pose =
      Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2) / 3);
  write_kitti_poses({Eigen::Isometry3d::Identity(), pose}, folder / "poses.txt");
  const auto poses = read_kitti_poses(folder / "poses.txt");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_TRUE(poses[1].isApprox(pose, 1e-10));
}

TEST(KittiPoses, RefusesWhatIsNoMotion) {
  const TemporaryFolder folder;
  write_text(folder / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n2 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_REFUSED(read_kitti_poses(folder / "poses.txt"), "poses.txt:2: the pose is no rigid motion");
  write_text(folder / "poses.txt", "-1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_REFUSED(read_kitti_poses(folder / "poses.txt"), "no rigid motion");
  write_text(folder / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 77\n");
  EXPECT_REFUSED(read_kitti_poses(folder / "poses.txt"), "poses.txt:2: the robot jumps by 77 m");
}

TEST(TumTrajectory, IsInterpolatedBetweenItsPoses) {
  const TemporaryFolder folder;
  write_text(folder / "groundtruth.txt", "# t x y z qx qy qz qw\n10.0 0 0 1 0 0 0 1\n10.1 2 0 1 0 0 1 0\n");
  const auto trajectory = read_tum_trajectory(folder / "groundtruth.txt");
  const Eigen::Isometry3d middle = pose_at(trajectory, 10.05, 0.2);
  EXPECT_NEAR(middle.translation().x(), 1, 1e-9);
  EXPECT_NEAR(std::abs(planar(middle).yaw_rad), M_PI / 2, 1e-6);
  EXPECT_TRUE(pose_at(trajectory, 10.0, 0.2).isApprox(trajectory[0].pose));
  EXPECT_REFUSED(pose_at(trajectory, 9.9, 0.2), "does not reach 9.900 s");
  EXPECT_REFUSED(pose_at(trajectory, 10.2, 0.2), "does not reach 10.200 s");
  EXPECT_REFUSED(pose_at(trajectory, 10.05, 0.05), "has a gap of 0.100 s");
}

TEST(TumTrajectory, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  write_text(folder / "a.txt", "1 0 0 1 0 0 0 0\n");
  EXPECT_REFUSED(read_tum_trajectory(folder / "a.txt"), "not of unit length");
  write_text(folder / "a.txt", "1 0 0 1 0 0 0 1\n1 0 0 1 0 0 0 1\n");
  EXPECT_REFUSED(read_tum_trajectory(folder / "a.txt"), "the timestamp does not grow");
}

}  // namespace
}  // namespace floorline
