#include "golden/pipeline.h"

#include <gtest/gtest.h>

#include "scene.h"

namespace floorline::golden {
namespace {

const cv::Size size(320, 240);
const cv::Rect obstacle(140, 60, 60, 70);

TEST(Pipeline, FindsTheObstacleAndOnlyIt) {
  Pipeline pipeline(size.height + 32);
  const Parameters parameters = parameters_of(size);
  EXPECT_TRUE(pipeline.process(view(size, 0, obstacle), parameters).obstacles.empty()) << "no reference yet";
  const Stages stages = pipeline.process(view(size, 1, obstacle), parameters);
  ASSERT_EQ(stages.obstacles.size(), 1u);
  const Contact& foot = stages.obstacles[0].nearest.contact;
  constexpr int reach = 3;  // Columns beside a line that count as on it.
  EXPECT_NEAR(foot.u, obstacle.x + obstacle.width / 2, obstacle.width / 2 + reach);
  EXPECT_NEAR(foot.v, obstacle.br().y - 1, shift_rows + 1);
  EXPECT_NEAR(stages.obstacles[0].nearest.x, (size.height - foot.v) * 0.01, 1e-12);
}

TEST(Pipeline, FloorAloneGivesNothing) {
  Pipeline pipeline(size.height + 32);
  const Parameters parameters = parameters_of(size);
  pipeline.process(view(size, 0, {}), parameters);
  const Stages stages = pipeline.process(view(size, 1, {}), parameters);
  EXPECT_EQ(cv::countNonZero(stages.difference), 0);
  EXPECT_TRUE(stages.points.empty());
}

TEST(Pipeline, UsesOtsusThresholdOfTheFrameBefore) {
  Pipeline pipeline(size.height + 32);
  Parameters parameters = parameters_of(size);
  parameters.threshold = {.floor = 0, .override_high = 0, .low = 0};
  EXPECT_EQ(pipeline.process(view(size, 0, obstacle), parameters).high_threshold, 0);
  const int found = pipeline.process(view(size, 1, obstacle), parameters).otsu_threshold;
  EXPECT_GT(found, 0);
  EXPECT_EQ(pipeline.process(view(size, 2, obstacle), parameters).high_threshold, found);
}

TEST(Pipeline, ErodesAndCutsToTheRowsOfInterest) {
  Pipeline pipeline(size.height + 32);
  Parameters parameters = parameters_of(size);
  parameters.erode_high = true;
  parameters.roi_first_row = 100;
  pipeline.process(view(size, 0, obstacle), parameters);
  const Stages stages = pipeline.process(view(size, 1, obstacle), parameters);
  EXPECT_LT(cv::countNonZero(stages.eroded.high), cv::countNonZero(stages.binary.high));
  EXPECT_EQ(cv::countNonZero(stages.region.low.rowRange(0, 100)), 0);
  EXPECT_GT(cv::countNonZero(stages.region.low), 0);
}

TEST(Pipeline, RectifiesColourFramesFirst) {
  const cv::Matx33d camera(200, 0, 159.5, 0, 200, 119.5, 0, 0, 1);
  const Lens lens(camera, {-0.2, 0, 0, 0, 0}, size, Interpolation::bilinear);
  Pipeline pipeline(size.height, lens);
  cv::Mat colour;
  cv::cvtColor(view(size, 0, obstacle), colour, cv::COLOR_GRAY2BGR);
  const Stages stages = pipeline.process(colour, parameters_of(size));
  EXPECT_TRUE(equal(stages.luma, lens.rectify(view(size, 0, obstacle))));
}

}  // namespace
}  // namespace floorline::golden
