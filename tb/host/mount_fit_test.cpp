#include "host/mount_fit.h"

#include "host/import.h"
#include "host/sequence.h"
#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

constexpr double degree = M_PI / 180;

TEST(MountFit, FindsThePitchRollAndHeightOfAPaintedFloor) {
  const Camera camera = test_camera();
  std::vector<cv::Mat> frames;
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 8; ++i) {
    const PlanarPose pose = {0.06 * i, 0.002 * i * i, 0.02 * i};
    frames.push_back(floor_view(camera, robot_from_camera(test_angles), pose));
    poses.push_back(isometry(pose));
  }
  MountAngles guess = test_angles;
  guess.pitch_rad += 2 * degree;
  guess.roll_rad -= 1.5 * degree;
  guess.height_m *= 1.08;
  const MountFit fit = fit_mount(camera, guess, frames, poses);
  EXPECT_NEAR(fit.angles.pitch_rad, test_angles.pitch_rad, 0.05 * degree);
  EXPECT_NEAR(fit.angles.roll_rad, test_angles.roll_rad, 0.05 * degree);
  EXPECT_NEAR(fit.angles.height_m, test_angles.height_m, 0.005 * test_angles.height_m);
  EXPECT_EQ(fit.angles.forward_m, test_angles.forward_m);
  EXPECT_LT(fit.residual, 0.2 * fit.residual_before);
  EXPECT_GT(fit.pairs, 3);
}

TEST(MountFit, RefusesARobotThatStands) {
  const Camera camera = test_camera();
  const std::vector<cv::Mat> frames(3, cv::Mat(camera.size, CV_8UC1, cv::Scalar(9)));
  const std::vector<Eigen::Isometry3d> poses(3, Eigen::Isometry3d::Identity());
  EXPECT_REFUSED(fit_mount(camera, test_angles, frames, poses), "hardly moves");
  EXPECT_REFUSED(fit_mount(camera, {.height_m = 1, .pitch_rad = -1}, frames, poses), "sees no floor");
}

/// plane.txt comes from stereo; the images of one camera and the poses must give it again, from a guess on
/// either side of it.
TEST(MountFit, AgreesWithTheStereoPlaneOfKitti) {
  SKIP_WITHOUT_SHARED_DATA("kitti_trk0003a");
  const TemporaryFolder folder;
  import_kitti(shared_data("kitti_trk0003a"), folder / "drive");
  const Sequence sequence(folder / "drive");
  std::vector<cv::Mat> frames;
  for (int i = 0; i < sequence.frame_count(); ++i) frames.push_back(sequence.frame(i));
  const MountAngles stereo = mount_angles(sequence.robot_from_camera());
  for (const double side : {-1, 1}) {
    MountAngles guess = stereo;
    guess.pitch_rad += side * 1.5 * degree;
    guess.roll_rad += side * degree;
    guess.height_m *= 1 - side * 0.05;
    const MountFit fit =
        fit_mount(sequence.camera(), guess, frames, sequence.world_from_robot(PoseSource::poses));
    EXPECT_LT(fit.residual, 0.5 * fit.residual_before);
    EXPECT_NEAR(fit.angles.pitch_rad, stereo.pitch_rad, 0.2 * degree);
    EXPECT_NEAR(fit.angles.roll_rad, stereo.roll_rad, 0.5 * degree);
    EXPECT_NEAR(fit.angles.height_m, stereo.height_m, 0.05 * stereo.height_m);
  }
}

}  // namespace
}  // namespace floorline
