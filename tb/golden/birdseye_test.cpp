#include "golden/birdseye.h"

#include <gtest/gtest.h>

namespace floorline::golden {
namespace {

/// A level camera 1 m above the floor with its horizon in row 100: x = 200 / (v - 100), y = (50 - u) / (v -
/// 100); Z = 1 in row 200.
const cv::Matx33d map(0, 0, 2, -0.01, 0, 0.5, 0, 0.01, -1);

TEST(Birdseye, MapsContactsInOrder) {
  const std::vector<FloorPoint> points =
      birdseye({{.line = 1, .u = 50, .v = 200}, {.line = 2, .u = 10, .v = 150}}, map);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_DOUBLE_EQ(points[0].x, 2);
  EXPECT_DOUBLE_EQ(points[0].y, 0);
  EXPECT_DOUBLE_EQ(points[1].x, 4);
  EXPECT_DOUBLE_EQ(points[1].y, 0.8);
  EXPECT_EQ(points[1].contact.line, 2);
}

TEST(Birdseye, DropsWhatTheFloorDoesNotResolve) {
  EXPECT_TRUE(birdseye({{.u = 50, .v = 90}, {.u = 50, .v = 100}, {.u = 50, .v = 106}}, map).empty());
  EXPECT_EQ(birdseye({{.u = 50, .v = 107}}, map).size(), 1u);
  const cv::Matx33d kilometres(1000, 0, 0, 0, 1, 0, 0, 0, 1);
  EXPECT_TRUE(birdseye({{.u = 1, .v = 0}}, kilometres).empty());
}

}  // namespace
}  // namespace floorline::golden
