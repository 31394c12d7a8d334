#include "golden/roi.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

TEST(Roi, ClearsTheRowsOutside) {
  const Masks masks = {random_mask({9, 12}, 50, 1), random_mask({9, 12}, 70, 2)};
  const Masks region = roi(masks, 3, 7);
  EXPECT_TRUE(equal(region.high.rowRange(3, 8), masks.high.rowRange(3, 8)));
  EXPECT_TRUE(equal(region.low.rowRange(3, 8), masks.low.rowRange(3, 8)));
  EXPECT_EQ(cv::countNonZero(region.high.rowRange(0, 3)) + cv::countNonZero(region.low.rowRange(8, 12)), 0);
}

TEST(Roi, TakesRowsBeyondTheImageAsItsLast) {
  const Masks masks = {random_mask({9, 12}, 50, 1), random_mask({9, 12}, 70, 2)};
  EXPECT_TRUE(equal(roi(masks, 0, 2000).high, masks.high));
  EXPECT_EQ(cv::countNonZero(roi(masks, 8, 4).low), 0);
}

}  // namespace
}  // namespace floorline::golden
