#include "tb/cosim/cycle_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace floorline::cosim {
namespace {

/// docs/cosimulation.md: width * height, and the longer of a line with its window's columns and Otsu's
/// search.
TEST(CycleTable, FollowsTheFormula) {
  constexpr int kLineOverhead = 8, kOtsu = 559;
  for (const cv::Size size : {cv::Size(16, 16), cv::Size(17, 19), cv::Size(33, 16), cv::Size(64, 48),
                              cv::Size(161, 121), cv::Size(640, 48), cv::Size(639, 32)}) {
    EXPECT_EQ(measure_cycles(size).frame_cycles, size.area() + std::max(size.width + kLineOverhead, kOtsu))
        << size.width << "x" << size.height;
  }
}

}  // namespace
}  // namespace floorline::cosim
