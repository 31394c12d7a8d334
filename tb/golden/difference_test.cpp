#include "golden/difference.h"

#include <gtest/gtest.h>

#include "test_image.h"

namespace floorline::golden {
namespace {

TEST(Difference, IsTheDistanceFromTheReferenceWhereThereIsOne) {
  const PixelPairs pairs = {.current = row_image({100, 40, 200, 90, 10}),
                            .reference = row_image({90, 60, 180, 90, 200}),
                            .gradient = row_image({1, 2, 3, 4, 5}),
                            .valid = row_image({255, 255, 255, 255, 0})};
  EXPECT_TRUE(equal(difference(pairs), row_image({10, 20, 20, 0, 0})));
}

}  // namespace
}  // namespace floorline::golden
