#include "host/parameters.h"

#include "golden/pipeline.h"
#include "host/fixed_point.h"
#include "host/import.h"
#include "host/line_table.h"
#include "host/sequence.h"
#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

const Camera camera = test_camera();
const Eigen::Isometry3d mount = robot_from_camera(test_angles);

TEST(Configuration, LooksBelowTheHorizonOfBothEdges) {
  const Configuration configuration(camera, mount, {.roi_margin_rows = 25});
  const double left = horizon_row(camera.matrix, mount, 0);
  const double right = horizon_row(camera.matrix, mount, 639);
  EXPECT_NEAR(configuration.roi().y, std::max(left, right) + 25, 1);
  EXPECT_EQ(configuration.roi().br(), cv::Point(640, 480));
}

TEST(Configuration, GivesBothFormsOfTheSameParameters) {
  Settings settings;
  settings.threshold = {.floor = 21, .override_high = 33, .low = 9};
  settings.min_rows = 14;
  settings.max_gap = 2;
  settings.erode = true;
  settings.cluster_gap_m = 0.3;
  settings.min_lines = 3;
  settings.reference.every = 1;
  const Configuration configuration(camera, mount, settings);
  ReferencePlan plan = configuration.reference_plan();
  plan.next(isometry({0, 0, 0}));
  const PlannedFrame frame = plan.next(isometry({0.04, 0, 0.01}));
  const golden::Parameters golden = configuration.golden_parameters(frame);
  const FrameParameters fixed = configuration.frame_parameters(frame, true);

  EXPECT_EQ(fixed.width.to_int(), 640);
  EXPECT_EQ(fixed.height.to_int(), 480);
  EXPECT_EQ(fixed.grey.to_int(), 1);
  EXPECT_EQ(fixed.replace_reference.to_int(), golden.replace_reference);
  EXPECT_EQ(fixed.erode_high.to_int(), golden.erode_high);
  EXPECT_EQ(fixed.roi_first_row.to_int(), golden.roi_first_row);
  EXPECT_EQ(fixed.roi_last_row.to_int(), golden.roi_last_row);
  EXPECT_EQ(fixed.line_count.to_int(), static_cast<int>(golden.lines.size()));
  EXPECT_NEAR(std::ldexp(fixed.cluster_gap.to_int(), -16), golden.cluster_gap_m, 1e-5);
  EXPECT_EQ(fixed.threshold.floor.to_int(), golden.threshold.floor);
  EXPECT_EQ(fixed.threshold.override_high.to_int(), golden.threshold.override_high);
  EXPECT_EQ(fixed.threshold.low.to_int(), golden.threshold.low);
  EXPECT_EQ(fixed.displacement.noise.to_int(), golden.displacement.noise);
  EXPECT_EQ(fixed.displacement.bound.to_int() / 65536.0, golden.displacement.bound_px);
  EXPECT_EQ(fixed.displacement.bound_step.to_int() / 65536.0, golden.displacement.bound_step_px);
  EXPECT_EQ(fixed.rule.run_rule.to_int(), golden.rule.kind == golden::Rule::run);
  EXPECT_EQ(fixed.rule.min_rows.to_int(), golden.rule.min_rows);
  EXPECT_EQ(fixed.rule.max_gap.to_int(), golden.rule.max_gap);
  EXPECT_EQ(fixed.rule.horizon_row.to_int(), golden.rule.horizon_row);
  EXPECT_EQ(fixed.rule.height_ratio.to_int() / 256.0, golden.rule.height_ratio);
  EXPECT_EQ(fixed.rule.min_lines.to_int(), golden.min_lines);
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(5, 150), Eigen::Vector2d(320, 300), Eigen::Vector2d(630, 470)}) {
    const auto mapped = [&](const cv::Matx33d& map) {
      return apply(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(map.val), pixel);
    };
    EXPECT_LT(
        (apply(unpack_homography(fixed.homography, camera.size), pixel) - mapped(golden.homography)).norm(),
        kHomographyErrorBound);
    EXPECT_LT((apply(unpack(fixed.birdseye), pixel) - mapped(golden.birdseye)).norm(), kBirdseyeErrorBound);
  }
}

TEST(Configuration, GoldenLinesAreThoseOfTheLineTable) {
  const Configuration configuration(camera, mount, {.line_count = 50});
  const golden::Parameters parameters = configuration.golden_parameters({});
  ASSERT_EQ(parameters.lines.size(), 50u);
  ASSERT_EQ(configuration.lines().size(), 50u);
  for (int i = 0; i < 50; ++i) {
    std::vector<cv::Point> walked;
    for (const golden::Step& step : golden::walk(parameters.lines[i]))
      walked.emplace_back(step.first_column, step.row);
    const std::vector<cv::Point> table = line_pixels(configuration.lines()[i]);
    EXPECT_EQ(walked.front(), table.front());
    EXPECT_EQ(walked.back().y, table.back().y);
  }
}

TEST(Configuration, BirdseyeFindsTheFloorOfALine) {
  const Configuration configuration(camera, mount, {});
  const Eigen::Vector2d pixel = pixel_of(camera, mount, {1.5, 0.2, 0});
  const cv::Vec3d floor = configuration.golden_parameters({}).birdseye * cv::Vec3d(pixel.x(), pixel.y(), 1);
  EXPECT_NEAR(floor[0] / floor[2], 1.5, 1e-9);
  EXPECT_NEAR(floor[1] / floor[2], 0.2, 1e-9);
}

TEST(Configuration, TakesTheSmallestBuildThatHoldsTheFrames) {
  EXPECT_EQ(Configuration(camera, mount, {}).ring_rows(), 480 + 32);
  Camera wide = camera;
  wide.size = {1242, 375};
  EXPECT_EQ(Configuration(wide, mount, {}).ring_rows(), 384 + 32);
  Camera huge = camera;
  huge.size = {1920, 1080};
  EXPECT_REFUSED(Configuration(huge, mount, {}), "fit no build of the accelerator");
}

TEST(Configuration, RefusesEachFaultWithASentence) {
  EXPECT_REFUSED(Configuration(camera, robot_from_camera({.height_m = 1, .pitch_rad = -0.8}), {}),
                 "sees no floor");
  EXPECT_REFUSED(
      Configuration(camera, robot_from_camera({.height_m = 1, .pitch_rad = -0.51}), {.roi_margin_rows = 60}),
      "reduce that margin");
  EXPECT_REFUSED(Configuration(camera, robot_from_camera({.height_m = -1}), {}), "not above the floor");
  EXPECT_REFUSED(Configuration(camera, mount, {.line_count = 1000}), "lines");
}

TEST(Configuration, AFootMayMoveByTheParallaxOfAFewRows) {
  const Settings settings = {.still_px = 0.5, .still_rows = 4};
  const Configuration configuration(camera, mount, settings);
  PlannedFrame frame;
  frame.baseline_m = 0.02;
  const golden::Parameters parameters = configuration.golden_parameters(frame);
  const Eigen::Vector2d foot = pixel_of(camera, mount, {2, 0, 0});
  const double bound = parameters.displacement.bound_px + foot.y() * parameters.displacement.bound_step_px;
  const double a_row = (bound - 0.5) / 4;
  // A point a little above that foot, seen from 2 cm further back as well.
  const Eigen::Isometry3d moved = isometry({0.02, 0, 0});
  const Eigen::Vector3d raised(2, 0, 0.02);
  const Eigen::Vector2d pixel = pixel_of(camera, mount, raised);
  const Eigen::Vector2d explained = apply(ground_homography(camera.matrix, mount, moved), pixel);
  const double parallax = (explained - pixel_of(camera, mount, moved * raised)).norm();
  EXPECT_NEAR(a_row * (foot.y() - pixel.y()), parallax, 0.1 * parallax);
}

TEST(Configuration, RectifiesADistortedCamera) {
  EXPECT_FALSE(Configuration(camera, mount, {}).lens());
  Camera distorted = camera;
  distorted.distortion = {-0.2, 0, 0, 0, 0};
  const auto lens = Configuration(distorted, mount, {}).lens();
  ASSERT_TRUE(lens);
  EXPECT_GT(lens->source(0, 0).x, 5) << "barrel distortion draws the corners in";
}

TEST(PaperSettings, AreThePapers) {
  const golden::Parameters parameters = Configuration(camera, mount, paper_settings()).golden_parameters({});
  EXPECT_EQ(parameters.rule.kind, golden::Rule::paper);
  EXPECT_TRUE(parameters.erode_high);
  EXPECT_EQ(golden::high_threshold(parameters.threshold, 17), 17);
}

/// Mean plain difference over the pixels of a mask value, frame against the one before.
struct GroundResidual {
  double still = 0;
  double warped = 0;
};

GroundResidual residual_on_floor(const Sequence& sequence, int frame) {
  const Configuration configuration(sequence.camera(), sequence.robot_from_camera(),
                                    {.reference = {.every = 1}});
  const auto poses = sequence.world_from_robot(PoseSource::poses);
  ReferencePlan plan = configuration.reference_plan();
  plan.next(poses[frame - 1]);
  golden::Parameters parameters = configuration.golden_parameters(plan.next(poses[frame]));
  parameters.replace_reference = false;
  golden::FrameRing ring(configuration.ring_rows());
  ring.pair(sequence.frame(frame - 1), cv::Matx33d::eye(), true);
  const golden::PixelPairs pairs = ring.pair(sequence.frame(frame), parameters.homography, false);
  const cv::Mat floor = (sequence.truth_mask(frame) == 0) & pairs.valid;
  cv::Mat still, warped;
  cv::absdiff(sequence.frame(frame - 1), sequence.frame(frame), still);
  cv::absdiff(pairs.reference, pairs.current, warped);
  return {cv::mean(still, floor)[0], cv::mean(warped, floor)[0]};
}

/// ipm_check.csv has for the same pairs, by another program with a plane fitted to each frame: 9.9 to 23 grey
/// levels without warp, 2.5 to 6.2 with full poses.
TEST(Kitti, TheGroundHomographyExplainsTheRoad) {
  for (const std::string name : {"kitti_odo06", "kitti_trk0003a"}) {
    SKIP_WITHOUT_SHARED_DATA(name);
    const TemporaryFolder folder;
    import_kitti(shared_data(name), folder / name);
    const Sequence sequence(folder / name);
    for (const int frame : {1, 5, 9}) {
      const GroundResidual residual = residual_on_floor(sequence, frame);
      EXPECT_GT(residual.still, 9) << name << " " << frame;
      EXPECT_LT(residual.warped, 9) << name << " " << frame;
      EXPECT_LT(residual.warped, 0.6 * residual.still) << name << " " << frame;
    }
  }
}

}  // namespace
}  // namespace floorline
