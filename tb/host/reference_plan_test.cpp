#include "host/reference_plan.h"

#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

const Camera camera = test_camera();
const Eigen::Isometry3d mount = robot_from_camera(test_angles);
const cv::Rect roi(0, 80, 640, 400);

ReferencePlan plan_with(const ReferenceRule& rule, int margin_rows = 32) {
  return {camera, mount, rule, roi, margin_rows};
}

/// Drives straight on by steps and returns the plans.
std::vector<PlannedFrame> drive(ReferencePlan plan, const std::vector<double>& places_m) {
  std::vector<PlannedFrame> frames;
  for (const double x : places_m) frames.push_back(plan.next(isometry({x, 0, 0})));
  return frames;
}

TEST(ReferencePlan, TheFirstFrameIsTheFirstReference) {
  const PlannedFrame first = drive(plan_with({}), {0})[0];
  EXPECT_EQ(first.reference, -1);
  EXPECT_TRUE(first.replace);
  EXPECT_FALSE(first.mature);
}

TEST(ReferencePlan, ReplacesEverySoManyFrames) {
  const auto frames = drive(plan_with({.every = 2}), {0, 0.02, 0.04, 0.06, 0.08, 0.1});
  const int references[] = {-1, 0, 0, 2, 2, 4};
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(frames[i].reference, references[i]) << i;
    EXPECT_EQ(frames[i].replace, i % 2 == 0) << i;
    EXPECT_EQ(frames[i].mature, i > 0 && i % 2 == 0) << i;
  }
}

TEST(ReferencePlan, WaitsForTheParallax) {
  const ReferenceRule rule = {.parallax_px = 1.0, .distance_m = 2, .height_m = 0.1};
  const auto frames = drive(plan_with(rule), {0, 0.01, 0.01, 0.01, 0.05, 0.3, 0.31});
  EXPECT_EQ(frames[3].reference, 0) << "a robot that stands keeps its reference";
  EXPECT_LT(frames[4].parallax_px, 1.0);
  EXPECT_FALSE(frames[4].replace);
  EXPECT_GE(frames[5].parallax_px, 1.0);
  EXPECT_TRUE(frames[5].mature);
  EXPECT_EQ(frames[6].reference, frames[5].mature && frames[5].replace ? 5 : 0);
}

TEST(ReferencePlan, ParallaxIsThatOfTheImages) {
  const ReferenceRule rule = {.every = 1, .distance_m = 2, .height_m = 0.2};
  const PlannedFrame frame = drive(plan_with(rule, 480), {0, 0.2})[1];
  // The point stands 2 m ahead now and 2.2 m ahead before; the floor explains its pixel as a place behind it.
  const Eigen::Vector2d explained = apply(frame.homography, pixel_of(camera, mount, {2, 0, 0.2}));
  EXPECT_NEAR(frame.parallax_px, (explained - pixel_of(camera, mount, {2.2, 0, 0.2})).norm(), 1e-9);
}

TEST(ReferencePlan, HomographyIsScaledInTheMiddleOfTheRoi) {
  const PlannedFrame frame = drive(plan_with({.every = 1}), {0, 0.05})[1];
  EXPECT_NEAR(frame.homography.row(2).dot(Eigen::RowVector3d(319.5, 279.5, 1)), 1, 1e-12);
}

/// Greatest number of rows by which floor in the ROI moves down.
double displacement(double step_m) {
  const Eigen::Matrix3d h = ground_homography(camera.matrix, mount, isometry({step_m, 0, 0}));
  double greatest = 0;
  for (int u = 0; u < 640; u += 9) {
    const Eigen::Vector2d before = apply(h, {u, 479});
    if (before.x() >= 0 && before.x() < 640) greatest = std::max(greatest, 479 - before.y());
  }
  return greatest;
}

TEST(ReferencePlan, SplitsWhatTheRingCannotHold) {
  ASSERT_GT(displacement(0.2), 32);
  const auto frames = drive(plan_with({.every = 1}), {0, 0.2, 0.4, 0.6});
  EXPECT_FALSE(frames[1].replace) << "detects while the reference is held";
  EXPECT_TRUE(frames[1].mature);
  EXPECT_TRUE(frames[2].replace) << "only replaces";
  EXPECT_FALSE(frames[2].mature);
  EXPECT_EQ(frames[3].reference, 2);
  EXPECT_TRUE(frames[3].mature);
}

TEST(ReferencePlan, ReplacesWhatTheRingHolds) {
  ASSERT_LT(displacement(0.05), 30);
  EXPECT_TRUE(drive(plan_with({.every = 1}), {0, 0.05})[1].replace);
}

TEST(ReferencePlan, RefusesAPoseThatIsNotFinite) {
  EXPECT_REFUSED(drive(plan_with({}), {0, NAN}), "not finite");
}

}  // namespace
}  // namespace floorline
