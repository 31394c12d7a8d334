#include "host/mount.h"

#include "test_files.h"

namespace floorline {
namespace {

constexpr MountAngles tilted = {.height_m = 0.6, .pitch_rad = 0.4, .roll_rad = -0.1, .forward_m = 0.2};

TEST(Mount, PitchLooksDownAndRollTurnsClockwise) {
  const Eigen::Isometry3d down = robot_from_camera({.height_m = 1, .pitch_rad = 0.5});
  const Eigen::Vector3d axis = down.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR(axis.x(), std::cos(0.5), 1e-12);
  EXPECT_NEAR(axis.z(), -std::sin(0.5), 1e-12);
  // Rolled clockwise, the camera's right side is lower.
  const Eigen::Isometry3d rolled = robot_from_camera({.height_m = 1, .roll_rad = 0.3});
  EXPECT_NEAR((rolled.linear() * Eigen::Vector3d::UnitX()).z(), -std::sin(0.3), 1e-12);
}

TEST(Mount, AnglesComeBack) {
  const MountAngles angles = mount_angles(robot_from_camera(tilted));
  EXPECT_NEAR(angles.height_m, tilted.height_m, 1e-12);
  EXPECT_NEAR(angles.pitch_rad, tilted.pitch_rad, 1e-12);
  EXPECT_NEAR(angles.roll_rad, tilted.roll_rad, 1e-12);
  EXPECT_NEAR(angles.forward_m, tilted.forward_m, 1e-12);
}

TEST(Mount, PlaneOfTheMountGivesItsAngles) {
  const Eigen::Vector3d down = robot_from_camera(tilted).linear().transpose() * -Eigen::Vector3d::UnitZ();
  const MountAngles angles = mount_from_plane(2 * down, 1.2);
  EXPECT_NEAR(angles.height_m, 0.6, 1e-12);
  EXPECT_NEAR(angles.pitch_rad, tilted.pitch_rad, 1e-12);
  EXPECT_NEAR(angles.roll_rad, tilted.roll_rad, 1e-12);
  EXPECT_REFUSED(mount_from_plane({0, 0, 0}, 1), "not below the camera");
  EXPECT_REFUSED(mount_from_plane({0, 1, 0}, -1), "not below the camera");
}

TEST(Mount, IsWrittenAndReadBack) {
  const TemporaryFolder folder;
  write_mount(robot_from_camera(tilted), folder / "mount.yaml");
  EXPECT_TRUE(read_mount(folder / "mount.yaml").isApprox(robot_from_camera(tilted), 1e-10));
}

TEST(Mount, RefusesEachFaultWithASentence) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& numbers) {
    write_text(folder / "mount.yaml", "robot_from_camera: [" + numbers + "]\n");
    return read_mount(folder / "mount.yaml");
  };
  EXPECT_NO_THROW(read("0,0,1,0, -1,0,0,0, 0,-1,0,0.5, 0,0,0,1"));
  EXPECT_REFUSED(read("0,0,1,0, -1,0,0,0, 0,-1,0,0.5"), "sixteen numbers");
  EXPECT_REFUSED(read("0,0,2,0, -1,0,0,0, 0,-1,0,0.5, 0,0,0,1"), "no rigid motion");
  EXPECT_REFUSED(read("0,0,1,0, 1,0,0,0, 0,-1,0,0.5, 0,0,0,1"), "no rigid motion");
  EXPECT_REFUSED(read("0,0,1,0, -1,0,0,0, 0,-1,0,0.5, 0,0,1,1"), "no rigid motion");
  EXPECT_REFUSED(read("0,0,1,0, -1,0,0,0, 0,-1,0,-0.5, 0,0,0,1"), "at or below the floor");
  EXPECT_REFUSED(read("0,0,1,0, -1,0,0,0, 0,-1,0,.inf, 0,0,0,1"), "not finite");
}

}  // namespace
}  // namespace floorline
