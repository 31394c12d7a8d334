#include "golden/binarize.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

TEST(Binarize, HighThresholdIsOtsusButNotBelowTheFloor) {
  const Thresholds thresholds = {.floor = 20, .override_high = 0, .low = 10};
  EXPECT_EQ(high_threshold(thresholds, 5), 20);
  EXPECT_EQ(high_threshold(thresholds, 35), 35);
}

TEST(Binarize, OverrideBeatsOtsuAndFloor) {
  EXPECT_EQ(high_threshold({.floor = 20, .override_high = 12, .low = 10}, 35), 12);
}

TEST(Binarize, SetsWhatIsAboveTheThreshold) {
  const cv::Mat image = row_image({0, 10, 11, 20, 21});
  const Masks masks = binarize(image, 20, 10);
  EXPECT_TRUE(equal(masks.high, row_image({0, 0, 0, 0, 255})));
  EXPECT_TRUE(equal(masks.low, row_image({0, 0, 255, 255, 255})));
}

}  // namespace
}  // namespace floorline::golden
