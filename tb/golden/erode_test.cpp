#include "golden/erode.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

TEST(Erode, IsTheMinimumOfNineOfTheHighMask) {
  const Masks masks = {random_mask({23, 17}, 85, 1), random_mask({23, 17}, 85, 2)};
  const Masks eroded = erode(masks);
  EXPECT_TRUE(equal(eroded.low, masks.low));
  for (int v = 0; v < 17; ++v) {
    for (int u = 0; u < 23; ++u) {
      const cv::Rect window = cv::Rect(u - 1, v - 1, 3, 3) & cv::Rect(0, 0, 23, 17);
      const bool all_set = cv::countNonZero(masks.high(window)) == window.area();
      EXPECT_EQ(eroded.high.at<uchar>(v, u), all_set ? 255 : 0) << u << " " << v;
    }
  }
}

}  // namespace
}  // namespace floorline::golden
