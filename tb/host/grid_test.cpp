#include "host/grid.h"

#include <opencv2/imgcodecs.hpp>

#include "host/parameters.h"
#include "host/text_file.h"
#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

/// Rays straight ahead, 5 cm apart, from 0.5 m on; an obstacle 1 m wide at `distance` stops those in its way.
std::vector<FloorRay> rays_with_obstacle(double distance_m) {
  std::vector<FloorRay> rays;
  for (int i = -20; i <= 20; ++i) {
    const double y = 0.05 * i;
    const bool hit = std::abs(y) < 0.5 && distance_m < 4;
    rays.push_back({{0.5, y}, {4, y}, {hit ? distance_m : 4, y}, hit});
  }
  return rays;
}

/// Enough for every distance of these tests to count in full.
constexpr double kParallax = 10;

const std::vector<FloorRay> open_floor = rays_with_obstacle(INFINITY);

/// The same rays, where `lines` of them end at each place; robot frame, Y a multiple of 5 cm.
std::vector<FloorRay> rays_ending_at(const std::vector<Eigen::Vector2d>& places, int lines = 3) {
  std::vector<FloorRay> rays = open_floor;
  for (const Eigen::Vector2d& place : places) {
    for (int i = 0; i < lines; ++i) {
      FloorRay& ray = rays.at(20 + std::lround(place.y() / 0.05) + i - lines / 2);
      ray.free.x() = place.x();
      ray.hit = true;
    }
  }
  return rays;
}

/// Frames that see something there until it is confirmed.
int frames_to_confirm(const std::vector<FloorRay>& rays, double parallax_px) {
  Grid grid({});
  for (int frames = 1; frames <= 100; ++frames) {
    grid.add({}, rays, parallax_px);
    if (!grid.confirmed().empty()) return frames;
  }
  return 1000;
}

TEST(FloorRays, EndAtTheNearestContact) {
  const Configuration configuration(test_camera(), robot_from_camera(test_angles), {.line_count = 40});
  const golden::Parameters parameters = configuration.golden_parameters({});
  const std::vector<FloorRay> open = floor_rays(parameters, {});
  ASSERT_EQ(open.size(), 40u);
  EXPECT_FALSE(open[20].hit);
  EXPECT_EQ(open[20].free, open[20].far);
  EXPECT_GT(open[20].far.norm(), open[20].near.norm());

  const golden::FloorPoint behind = {{.line = 20}, 3.0, 0.1};
  const golden::FloorPoint before = {{.line = 20}, 1.5, 0.05};
  const golden::FloorPoint clipped = {{.line = 21, .clipped = true}, 0.8, 0.0};
  const std::vector<FloorRay> rays = floor_rays(parameters, {behind, before, clipped});
  EXPECT_TRUE(rays[20].hit);
  EXPECT_EQ(rays[20].free, Eigen::Vector2d(1.5, 0.05));
  EXPECT_FALSE(rays[21].hit);
  EXPECT_EQ(rays[21].free, rays[21].near) << "the foot lies below the image: nothing is proven free";
}

TEST(FloorRays, LinesThatDoNotSeeTheFloorGiveNone) {
  golden::Parameters parameters =
      Configuration(test_camera(), robot_from_camera(test_angles), {}).golden_parameters({});
  parameters.lines = {{{320, 0}, {320, 40}}};
  EXPECT_TRUE(floor_rays(parameters, {}).empty());
}

TEST(SlidingPlace, StaysWhereAFootIs) {
  SlidingPlace place(1000, 0.01);
  for (int i = 0; i < 20; ++i) place.add({3, 1}, {0.05 * i, 0}, 1);
  EXPECT_TRUE(place.foot().isApprox(Eigen::Vector2d(3, 1)));
  EXPECT_TRUE(place.seen_from({2, 0}).isApprox(Eigen::Vector2d(3, 1)));
}

TEST(SlidingPlace, FindsTheFootBelowAPointOfTheBody) {
  const Eigen::Vector2d foot(3, 1);
  const double height_share = 0.15 / 0.6;  // Of the camera's height.
  const auto seen_from = [&](const Eigen::Vector2d& robot) -> Eigen::Vector2d {
    return robot + (foot - robot) / (1 - height_share);
  };
  SlidingPlace sliding(1000, 0.001), steadied(1000, 100);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d robot(0.05 * i, 0.01 * i);
    sliding.add(seen_from(robot), robot, 1);
    steadied.add(seen_from(robot), robot, 1);
  }
  EXPECT_LT((sliding.foot() - foot).norm(), 0.01);
  EXPECT_LT((sliding.seen_from({1, 0.2}) - seen_from({1, 0.2})).norm(), 0.01);
  EXPECT_GT((steadied.foot() - foot).norm(), 0.5) << "too little way to tell a body from a foot";
}

TEST(SlidingPlace, IsTheMeanWhileTheRobotStands) {
  SlidingPlace place(1000, 0.01);
  place.add({3, 1}, {0, 0}, 1);
  place.add({3.2, 1}, {0, 0}, 1);
  EXPECT_NEAR(place.foot().x(), 3.1, 1e-3);
}

TEST(SlidingPlace, ForgetsOldFrames) {
  SlidingPlace place(3, 1);
  place.add({3, 1}, {0, 0}, 1);
  for (int i = 0; i < 20; ++i) place.add({3.2, 1}, {0, 0}, 1);
  EXPECT_NEAR(place.foot().x(), 3.2, 1e-3);
}

TEST(Grid, LearnsWhatIsOccupiedAndFree) {
  Grid grid({});
  EXPECT_EQ(grid.occupancy({2, 0}), 0.5);
  for (int i = 0; i < 4; ++i) grid.add({}, rays_with_obstacle(2.02), kParallax);
  EXPECT_GT(grid.occupancy({2.02, 0}), 0.9);
  EXPECT_LT(grid.occupancy({1.5, 0}), 0.2);
  EXPECT_EQ(grid.occupancy({2.5, 0}), 0.5) << "behind the obstacle nothing is known";
  EXPECT_LT(grid.occupancy({2.5, 0.8}), 0.2) << "beside it the view is free";
}

TEST(Grid, FreeFloorDisprovesAnObstacle) {
  Grid grid({});
  for (int i = 0; i < 10; ++i) grid.add({}, rays_with_obstacle(2.02), kParallax);
  for (int i = 0; i < 20; ++i) grid.add({}, open_floor, kParallax);
  EXPECT_LT(grid.occupancy({2.02, 0}), 0.2);
}

TEST(Grid, PlacesThingsByTheRobotsPose) {
  Grid grid({});
  // Facing +Y from (1, 1): ahead is +Y, left is -X.
  for (int i = 0; i < 4; ++i) grid.add({1, 1, M_PI / 2}, rays_with_obstacle(2.02), kParallax);
  EXPECT_GT(grid.occupancy({1.02, 3.02}), 0.9);
  ASSERT_EQ(grid.confirmed().size(), 1u);
  EXPECT_TRUE(grid.confirmed()[0].place.isApprox(Eigen::Vector2d(1, 3.02)));
}

TEST(Grid, DoesNotJudgeBeyondItsRange) {
  Grid grid({.range_m = 3});
  for (int i = 0; i < 4; ++i) grid.add({}, rays_with_obstacle(3.5), kParallax);
  EXPECT_EQ(grid.occupancy({3.5, 0}), 0.5);
  EXPECT_LT(grid.occupancy({2.9, 0}), 0.5);
  EXPECT_TRUE(grid.confirmed().empty());
}

TEST(Grid, ConfirmsWhatIsSeenAgain) {
  Grid grid({});
  grid.add({}, rays_ending_at({{2, 0}}), kParallax);
  EXPECT_TRUE(grid.confirmed().empty());
  grid.add({}, rays_ending_at({{2.1, 0}}), kParallax);
  ASSERT_EQ(grid.confirmed().size(), 1u);
  EXPECT_GT(grid.confirmed()[0].place.x(), 2.03);
  EXPECT_LT(grid.confirmed()[0].place.x(), 2.07);
  EXPECT_EQ(grid.confirmed()[0].reports, 2);
}

TEST(Grid, AFrameCountsByItsParallax) {
  // At 2.5 m the parallax is that of the frame.
  const double full_px = GridSettings().report_parallax_px;
  const std::vector<FloorRay> rays = rays_ending_at({{2.5, 0}});
  const int frames = frames_to_confirm(rays, full_px);
  EXPECT_EQ(frames_to_confirm(rays, 10 * full_px), frames);
  EXPECT_GT(frames_to_confirm(rays, full_px / 2), frames);
  EXPECT_EQ(frames_to_confirm(rays, 0), 1000) << "without a baseline nothing is confirmed";
  Grid grid({});
  for (int i = 0; i < frames; ++i) grid.add({}, rays, full_px);
  for (int i = 0; i < 100; ++i) grid.add({}, open_floor, 0);
  EXPECT_EQ(grid.confirmed().size(), 1u) << "...or disproved";
}

TEST(Grid, DropsWhatLaterFramesDoNotSee) {
  Grid grid({});
  for (int i = 0; i < 4; ++i) grid.add({}, rays_ending_at({{2, 0}}), kParallax);
  const int id = grid.confirmed().at(0).id;
  grid.add({}, open_floor, kParallax);
  EXPECT_EQ(grid.confirmed().size(), 1u) << "one frame may miss it";
  for (int i = 0; i < 5; ++i) grid.add({}, open_floor, kParallax);
  EXPECT_TRUE(grid.confirmed().empty());
  for (int i = 0; i < 2; ++i) grid.add({}, rays_ending_at({{2, 0}}), kParallax);
  EXPECT_NE(grid.confirmed().at(0).id, id);
}

TEST(Grid, KeepsWhatIsOutOfViewOrHidden) {
  Grid grid({});
  for (int i = 0; i < 4; ++i) grid.add({}, rays_ending_at({{2, 0}}), kParallax);
  const int id = grid.confirmed().at(0).id;
  for (int i = 0; i < 10; ++i) grid.add({0, 0, M_PI}, open_floor, kParallax);  // The robot has turned round.
  ASSERT_EQ(grid.confirmed().size(), 1u);
  for (int i = 0; i < 10; ++i) grid.add({}, rays_with_obstacle(1), kParallax);  // Something wide before it.
  ASSERT_EQ(grid.confirmed().size(), 2u);
  EXPECT_EQ(grid.confirmed()[0].id, id);
  EXPECT_NE(grid.confirmed()[1].id, id);
}

TEST(Grid, OfTwoThatAreNearTheSurerStands) {
  Grid grid({});
  for (int i = 0; i < 2; ++i) grid.add({}, rays_ending_at({{2, 0.5}}), kParallax);
  for (int i = 0; i < 2; ++i) grid.add({}, rays_ending_at({{2, 0}, {2, 0.5}}, 1), kParallax);
  ASSERT_EQ(grid.confirmed().size(), 1u);
  EXPECT_NEAR(grid.confirmed()[0].place.y(), 0.5, 0.06);
}

TEST(Grid, AWideObstacleInOneFrameIsOneFrame) {
  Grid grid({});
  grid.add({}, rays_with_obstacle(2.02), kParallax);
  EXPECT_TRUE(grid.confirmed().empty());
}

TEST(Grid, ConfirmsABodyAtItsFoot) {
  // What rests 10 cm above the foot at (3, 0) slides towards a robot that drives ahead.
  GridSettings settings;
  settings.settling_reports = 100;
  settings.steadying_m2 = 0.01;
  Grid grid(settings);
  for (int i = 0; i < 30; ++i) {
    const double driven_m = 0.03 * i;
    grid.add({driven_m, 0, 0}, rays_ending_at({{(3 - driven_m) * 0.6 / 0.5, 0}}), kParallax);
  }
  ASSERT_EQ(grid.confirmed().size(), 1u);
  EXPECT_NEAR(grid.confirmed()[0].place.x(), 3, 0.1) << "it was seen at 3.6 to 3.43";
}

TEST(Grid, WritesAMapForMapServer) {
  const TemporaryFolder folder;
  Grid grid({});
  EXPECT_REFUSED(grid.write(folder.path()), "grid is empty");
  for (int i = 0; i < 6; ++i) grid.add({}, rays_with_obstacle(2.02), kParallax);
  grid.write(folder.path());
  const std::string yaml = read_text(folder / "map.yaml");
  EXPECT_THAT(yaml, testing::HasSubstr("image: map.png\nresolution: 0.05\norigin: [0.5, "));
  EXPECT_THAT(yaml, testing::HasSubstr("occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  const cv::Mat map = cv::imread((folder / "map.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(map.type(), CV_8UC1);
  // The obstacle at x = 2.02, y = 0.02: column 30 from x = 0.5, row from the top by Y.
  const auto grey_at = [&](double x, double y) {
    const double top = map.rows * 0.05 - 1.0;  // Y of the upper edge: the lowest ray is at -1 m.
    return map.at<uchar>(static_cast<int>((top - y) / 0.05), static_cast<int>((x - 0.5) / 0.05));
  };
  EXPECT_EQ(grey_at(2.02, 0.02), 0);
  EXPECT_EQ(grey_at(1.52, 0.02), 254);
  EXPECT_EQ(grey_at(3.02, 0.02), 205);
}

TEST(GridSettings, GrowWithTheCamera) {
  const GridSettings settings = grid_settings(1.2);
  EXPECT_NEAR(settings.range_m, 2 * GridSettings{}.range_m, 1e-12);
  EXPECT_NEAR(settings.resolution_m, 2 * GridSettings{}.resolution_m, 1e-12);
  EXPECT_NEAR(settings.radius_m, 2 * GridSettings{}.radius_m, 1e-12);
  EXPECT_NEAR(settings.merge_m, 2 * GridSettings{}.merge_m, 1e-12);
  EXPECT_NEAR(settings.steadying_m2, 4 * GridSettings{}.steadying_m2, 1e-12);
}

}  // namespace
}  // namespace floorline
