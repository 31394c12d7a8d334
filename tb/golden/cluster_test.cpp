#include "golden/cluster.h"

#include <gtest/gtest.h>

namespace floorline::golden {
namespace {

FloorPoint point(int line, double x, double y) { return {{.line = line}, x, y}; }

TEST(Cluster, JoinsWhatLiesTogether) {
  const auto obstacles = cluster({point(4, 2.0, 0.1), point(5, 1.9, 0.0), point(90, 2.0, -0.1)}, 0.25, 2);
  ASSERT_EQ(obstacles.size(), 1u);
  EXPECT_EQ(obstacles[0].first_line, 4);
  EXPECT_EQ(obstacles[0].last_line, 90);
  EXPECT_EQ(obstacles[0].nearest.contact.line, 5) << "the point nearest to the robot stands for the obstacle";
}

TEST(Cluster, ReportsTheNearestFirst) {
  const auto obstacles =
      cluster({point(4, 3.0, 0), point(5, 3.1, 0), point(6, 2.0, 0), point(7, 2.1, 0)}, 0.25, 2);
  ASSERT_EQ(obstacles.size(), 2u);
  EXPECT_EQ(obstacles[0].first_line, 6);
  EXPECT_EQ(obstacles[1].first_line, 4);
}

TEST(Cluster, ReachesAsFarAsTheGapInXAndY) {
  EXPECT_EQ(cluster({point(4, 2, 0), point(5, 2.25, 0.25)}, 0.25, 1).size(), 1u);
  EXPECT_EQ(cluster({point(4, 2, 0), point(5, 2.26, 0)}, 0.25, 1).size(), 2u);
  EXPECT_EQ(cluster({point(4, 2, 0), point(5, 2, -0.26)}, 0.25, 1).size(), 2u);
}

TEST(Cluster, DoesNotGrowBeyondTheGapAroundItsNearestPoint) {
  const auto obstacles = cluster({point(4, 2, 0), point(5, 2.2, 0), point(6, 2.4, 0)}, 0.25, 1);
  ASSERT_EQ(obstacles.size(), 2u);
  EXPECT_EQ(obstacles[1].first_line, 6);
}

TEST(Cluster, LooksAtTheNearestSixtyFour) {
  std::vector<FloorPoint> points;
  for (int line = 0; line < 70; ++line) points.push_back(point(line, 70.0 - line, 0));
  const auto obstacles = cluster(points, 0.25, 1);
  ASSERT_EQ(obstacles.size(), 64u);
  EXPECT_EQ(obstacles[63].nearest.x, 64);
}

TEST(Cluster, DropsObstaclesOfTooFewLines) {
  EXPECT_TRUE(cluster({point(4, 2, 0), point(9, 3, 0)}, 0.25, 2).empty());
}

TEST(Cluster, TakesOfEachLineThePointNearestToTheRobot) {
  const auto obstacles = cluster({point(4, 3, 0), point(4, 2, 0), point(4, 2.5, 0), point(5, 2, 0)}, 0.25, 2);
  ASSERT_EQ(obstacles.size(), 1u);
  EXPECT_DOUBLE_EQ(obstacles[0].nearest.x, 2);
}

TEST(Cluster, WithoutPointsThereAreNoObstacles) { EXPECT_TRUE(cluster({}, 0.25, 1).empty()); }

}  // namespace
}  // namespace floorline::golden
