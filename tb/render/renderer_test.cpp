#include "render/renderer.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "render/trajectory.h"
#include "render/truth.h"

namespace floorline::render {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;
using Eigen::Vector3d;

// A folder of its own for each test, removed at the end.
class RendererTest : public testing::Test {
 protected:
  RendererTest()
      : root_(fs::temp_directory_path() /
              (std::string("floorline_") + testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~RendererTest() override { fs::remove_all(root_); }

  fs::path folder(const std::string& name) const { return root_ / name; }

  // A box in the middle of the view, a marking before it.
  static Scene small_scene() {
    Scene scene;
    scene.image.width = 160;
    scene.image.height = 120;
    scene.camera.focal_px = 105;
    scene.path.segments = {{3, 0.05, 1.0}};
    ObstacleShape box;
    box.material.pattern = Pattern::fabric;
    scene.obstacles = {box};
    scene.markings = {{{{1.0, -0.3}, {1.1, -0.3}, {1.1, 0.3}, {1.0, 0.3}}, {}}};
    return scene;
  }

  static std::vector<char> bytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path root_;
};

TEST_F(RendererTest, GivesTheSameBytesOnAnyNumberOfThreads) {
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    render_sequence(small_scene(), folder("one"));
  }
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  render_sequence(small_scene(), folder("four"));
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder("one"))) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(bytes(entry.path()), bytes(folder("four") / fs::relative(entry.path(), folder("one"))))
        << entry.path();
    ++files;
  }
  EXPECT_GE(files, 3 + 3 + 5);
}

TEST_F(RendererTest, NoiseDependsOnTheSeed) {
  Scene scene = small_scene();
  render_sequence(scene, folder("a"));
  ++scene.seed;
  render_sequence(scene, folder("b"));
  EXPECT_NE(bytes(folder("a") / "frames/000000.png"), bytes(folder("b") / "frames/000000.png"));
}

TEST_F(RendererTest, ContactCurveLiesWhereTheMaskTurnsFromObstacleToFloor) {
  const Scene scene = small_scene();
  render_sequence(scene, folder("out"));
  const std::vector<TrueFrame> truth = read_truth(folder("out") / "truth/contacts.json");
  const std::vector<TrajectoryFrame> way = plan_trajectory(scene);
  const Eigen::Isometry3d camera_from_robot = robot_from_camera(scene.camera).inverse();
  ASSERT_EQ(truth.size(), 3u);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const cv::Mat mask =
        cv::imread((folder("out") / "truth/masks" / ("00000" + std::to_string(i) + ".png")).string(),
                   cv::IMREAD_UNCHANGED);
    ASSERT_EQ(truth[i].obstacles.size(), 1u);
    const TrueObstacle& box = truth[i].obstacles[0];
    EXPECT_EQ(box.kind, "box");
    EXPECT_NEAR(box.contact_share, 1.0, 0.05);
    EXPECT_EQ(box.visible_pixels, cv::countNonZero(mask == MaskValue::first_obstacle));
    int checked = 0;
    for (const Vector2d& point : box.contact.at(0)) {
      const Vector3d p = camera_from_robot * Vector3d(point.x(), point.y(), 0);
      const Vector2d pixel = p.head<2>() / p.z() * scene.camera.focal_px + Vector2d(79.5, 59.5);
      const auto column = static_cast<int>(std::lround(pixel.x())),
                 row = static_cast<int>(std::lround(pixel.y()));
      if (mask.at<std::uint8_t>(row - 2, column) == MaskValue::floor) continue;  // beside the foot's corner
      EXPECT_EQ(mask.at<std::uint8_t>(row - 2, column), MaskValue::first_obstacle) << column << " " << row;
      EXPECT_LT(mask.at<std::uint8_t>(row + 2, column), MaskValue::wall) << column << " " << row;
      ++checked;
    }
    EXPECT_GT(checked, 10);
    EXPECT_GT(cv::countNonZero(mask == MaskValue::marking), 20);
    EXPECT_GT(cv::countNonZero(mask == MaskValue::wall), 20);
  }
}

TEST_F(RendererTest, HiddenAndDistantFeetAreNotVisible) {
  Scene scene = small_scene();
  scene.path.segments = {{1, 0, 0}};
  ObstacleShape screen;  // hides the box
  screen.position = {1.2, 0};
  screen.size = {0.05, 3.0, 2.0};
  scene.obstacles.push_back(screen);
  render_sequence(scene, folder("out"));
  const std::vector<TrueFrame> truth = read_truth(folder("out") / "truth/contacts.json");
  ASSERT_EQ(truth[0].obstacles.size(), 1u);
  EXPECT_EQ(truth[0].obstacles[0].id, 1);
}

TEST_F(RendererTest, LeavesNothingBehindWhenItIsStopped) {
  EXPECT_THROW(render_sequence(small_scene(), folder("out"), [](int done, int) { return done < 2; }),
               std::exception);
  EXPECT_TRUE(fs::is_empty(folder("out").parent_path()));
}

TEST_F(RendererTest, RefusesAFolderThatExists) {
  fs::create_directories(folder("out"));
  EXPECT_THROW(render_sequence(small_scene(), folder("out")), std::exception);
}

TEST(Trajectory, OdometryWithoutNoiseIsExact) {
  Scene scene;
  scene.path.segments = {{10, 0.1, 5.0}};
  scene.odometry = {0, 0, 0, 0, 0};
  const std::vector<TrajectoryFrame> way = plan_trajectory(scene);
  ASSERT_EQ(way.size(), 10u);
  EXPECT_EQ(way[0].exact.position, scene.path.start);
  EXPECT_NEAR(way[9].exact.yaw, 45 * M_PI / 180, 1e-12);
  for (const TrajectoryFrame& frame : way) {
    EXPECT_NEAR((frame.exact.position - frame.odometry.position).norm(), 0, 1e-12);
    EXPECT_NEAR(frame.world_from_robot(2, 2), 1, 1e-12);
  }
}

TEST(Trajectory, SlipLengthensWhatTheWheelsTell) {
  Scene scene;
  scene.path.segments = {{11, 0.1, 0.0}};
  scene.odometry = {0, 0, 0, 1, 0.5};
  EXPECT_NEAR(plan_trajectory(scene).back().odometry.position.x(), 1.5, 1e-12);
}

TEST(Trajectory, MountLooksForwardAndDown) {
  Camera camera;
  camera.pitch_deg = 30;
  const Vector3d forward = robot_from_camera(camera).linear() * Vector3d::UnitZ();
  EXPECT_NEAR(forward.x(), std::cos(M_PI / 6), 1e-12);
  EXPECT_NEAR(forward.z(), -0.5, 1e-12);
  EXPECT_NEAR((robot_from_camera(camera).linear() * Vector3d::UnitX()).y(), -1, 1e-12);
}

}  // namespace
}  // namespace floorline::render
