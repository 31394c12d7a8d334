#include "render/score.h"

#include <gmock/gmock.h>

#include <cmath>

namespace floorline::render {
namespace {

using Eigen::Vector2d;

// A box 2 m ahead, a low step, a wall 3.5 m ahead, a marking at 1 m.
TrueFrame frame() {
  TrueFrame truth;
  truth.obstacles = {{0, "box", 0.3, 1000, 1.0, {{{2.0, -0.2}, {2.0, 0.2}}}},
                     {1, "box", 0.05, 1000, 1.0, {{{1.5, -1.0}, {1.5, -0.8}}}}};
  truth.walls = {{{3.5, -2.0}, {3.5, 2.0}}};
  truth.markings = {{{1.0, -0.1}, {1.1, -0.1}, {1.1, 0.1}, {1.0, 0.1}}};
  return truth;
}

TEST(Score, CountsARightReportAndItsError) {
  const Score score = score_reports({{2.05, 0.1}}, frame(), {});
  EXPECT_EQ(score.due, 1);
  EXPECT_EQ(score.found, 1);
  EXPECT_EQ(score.recall(), 1.0);
  EXPECT_EQ(score.precision(), 1.0);
  EXPECT_NEAR(score.median_error_m(), 0.05, 1e-12);
  EXPECT_EQ(score.duplicates, 0);
}

TEST(Score, MissingAndWrongReports) {
  const Score score = score_reports({{2.3, 0.0}}, frame(), {});
  EXPECT_EQ(score.found, 0);
  EXPECT_EQ(score.wrong, 1);
  EXPECT_EQ(score.recall(), 0.0);
  EXPECT_TRUE(std::isnan(score.median_error_m()));
}

TEST(Score, SecondReportAtOneFootIsADuplicate) {
  const Score score = score_reports({{2.0, -0.2}, {2.0, 0.2}}, frame(), {});
  EXPECT_EQ(score.right, 2);
  EXPECT_EQ(score.duplicates, 1);
  EXPECT_EQ(score.duplicate_share(), 0.5);
}

TEST(Score, WallsMakeReportsRightButAreNotDue) {
  const Score score = score_reports({{3.5, 1.0}, {3.5, -1.0}}, frame(), {});
  EXPECT_EQ(score.right, 2);
  EXPECT_EQ(score.at_obstacles, 0);
  EXPECT_EQ(score.duplicates, 0);
  EXPECT_EQ(score.found, 0);
}

TEST(Score, LowObstaclesAndDistantReportsAreNeutral) {
  const Score score = score_reports({{1.5, -0.9}, {4.5, 0.0}}, frame(), {});
  EXPECT_EQ(score.neutral, 2);
  EXPECT_EQ(score.right + score.wrong, 0);
}

TEST(Score, ReportsOnAMarkingCountAgainstIt) {
  const Score score = score_reports({{1.05, 0.0}, {1.0, 0.14}}, frame(), {});
  EXPECT_EQ(score.wrong, 2);
  EXPECT_EQ(score.marked, 1);
  EXPECT_EQ(score.markings, 1);
}

TEST(Score, HiddenSmallOrFarObstaclesAreNotDue) {
  TrueFrame hidden = frame(), small = frame(), far = frame();
  hidden.obstacles[0].contact_share = 0.1;
  small.obstacles[0].visible_pixels = 10;
  for (Vector2d& point : far.obstacles[0].contact[0]) point.x() += 3;
  for (const TrueFrame& truth : {hidden, small, far}) EXPECT_EQ(score_reports({}, truth, {}).due, 0);
}

TEST(Score, ToleranceGrowsWithDistance) {
  ScoreRules rules;
  rules.tolerance_share = 0.2;
  EXPECT_EQ(score_reports({{2.3, 0.0}}, frame(), rules).right, 1);
}

TEST(Score, Adds) {
  Score sum = score_reports({{2.0, 0.0}}, frame(), {});
  sum += score_reports({{1.05, 0.0}}, frame(), {});
  EXPECT_EQ(sum.due, 2);
  EXPECT_EQ(sum.found, 1);
  EXPECT_EQ(sum.precision(), 0.5);
  EXPECT_EQ(sum.errors_m.size(), 1u);
}

TEST(PixelScore, CountsBelowTheHorizonAndSkipsUnknown) {
  cv::Mat truth = (cv::Mat_<std::uint8_t>(2, 4) << 16, 16, 16, 16, 0, 2, 17, 255);
  cv::Mat mask = (cv::Mat_<std::uint8_t>(2, 4) << 0, 0, 0, 0, 255, 255, 0, 255);
  const PixelScore score = score_pixels(mask, truth, 1);
  EXPECT_EQ(score.hit, 1);
  EXPECT_EQ(score.false_alarm, 1);
  EXPECT_EQ(score.missed, 1);
  EXPECT_EQ(score.precision(), 0.5);
}

}  // namespace
}  // namespace floorline::render
