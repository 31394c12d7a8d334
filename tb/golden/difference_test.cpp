#include "golden/difference.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

const PixelPairs pairs = {.current = row_image({100, 40, 200, 90, 10}),
                          .nearest = row_image({90, 60, 180, 90, 200}),
                          .low = row_image({80, 50, 150, 90, 0}),
                          .high = row_image({110, 70, 190, 95, 255}),
                          .valid = row_image({255, 255, 255, 255, 0})};

TEST(Difference, PlainIsTheDistanceFromTheNearestPixel) {
  EXPECT_TRUE(equal(difference(pairs, false), row_image({10, 20, 20, 0, 0})));
}

TEST(Difference, TolerantIsTheDistanceFromTheCellsRange) {
  EXPECT_TRUE(equal(difference(pairs, true), row_image({0, 10, 10, 0, 0})));
}

}  // namespace
}  // namespace floorline::golden
