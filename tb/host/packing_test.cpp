#include "host/packing.h"

#include <gtest/gtest.h>

namespace floorline {
namespace {

TEST(Packing, FieldsFollowEachOtherFromBitZero) {
  LineCount count = {};
  count.line = 5;
  EXPECT_EQ(pack(count), (PackedElement{5, 0, 0, 0}));
  LineSetup line = {};
  line.first_column = -1;  // 13 bits, two's complement
  line.first_row = 3;
  EXPECT_EQ(pack(line), (PackedElement{0x1fffu | 3u << 13, 0, 0, 0}));
}

TEST(Packing, UnpackingGivesTheElementBack) {
  FloorPoint point = {};
  point.line = 200, point.u = -7, point.v = 479, point.rows = 33, point.x = 123456, point.y = -98765;
  point.clipped = 1;
  const FloorPoint point_again = unpack_floor_point(pack(point));
  EXPECT_EQ(point_again.line, point.line);
  EXPECT_EQ(point_again.u, point.u);
  EXPECT_EQ(point_again.v, point.v);
  EXPECT_EQ(point_again.rows, point.rows);
  EXPECT_EQ(point_again.x, point.x);
  EXPECT_EQ(point_again.y, point.y);
  EXPECT_EQ(point_again.clipped, point.clipped);
  EXPECT_EQ(point_again.end, point.end);

  Obstacle obstacle = {};
  obstacle.first_line = 3, obstacle.last_line = 9, obstacle.y = -4, obstacle.end = 1;
  const Obstacle obstacle_again = unpack_obstacle(pack(obstacle));
  EXPECT_EQ(obstacle_again.first_line, obstacle.first_line);
  EXPECT_EQ(obstacle_again.last_line, obstacle.last_line);
  EXPECT_EQ(obstacle_again.y, obstacle.y);
  EXPECT_EQ(obstacle_again.end, obstacle.end);

  LineCount count = {};
  count.line = 255, count.count = 600, count.end = 1;
  const LineCount count_again = unpack_line_count(pack(count));
  EXPECT_EQ(count_again.line, count.line);
  EXPECT_EQ(count_again.count, count.count);
  EXPECT_EQ(count_again.end, count.end);
}

}  // namespace
}  // namespace floorline
