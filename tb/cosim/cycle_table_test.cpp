#include "tb/cosim/cycle_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace floorline::cosim {
namespace {

/// docs/cosimulation.md: width * height, and the longer of a line with its window's columns and Otsu's
/// search, which depends on how many grey levels it has to compare.
bool follows_the_formula(cv::Size size, int cycles) {
  constexpr int kLine = 8, kSearch = 503, kContender = 54, kBetter = 7, kMostContenders = 3;
  for (int contenders = 1; contenders <= kMostContenders; ++contenders) {
    for (int better = 0; better < contenders; ++better) {
      const int search = kSearch + kContender * contenders + kBetter * better;
      if (cycles == size.area() + std::max(size.width + kLine, search)) return true;
    }
  }
  return false;
}

TEST(CycleTable, FollowsTheFormula) {
  for (const cv::Size size :
       {cv::Size(16, 16), cv::Size(17, 19), cv::Size(33, 16), cv::Size(64, 48), cv::Size(161, 121),
        cv::Size(640, 48), cv::Size(639, 32), cv::Size(640, 480), cv::Size(1280, 384)}) {
    const std::uint32_t cycles = measure_cycles(size, Stalls::none).frame_cycles;
    EXPECT_TRUE(follows_the_formula(size, static_cast<int>(cycles)))
        << size.width << "x" << size.height << ": " << cycles;
  }
}

TEST(CycleTable, StagesEndInTheOrderOfTheData) {
  const cv::Size size(161, 121);
  const std::vector<StageRun> stages = measure_cycles(size, Stalls::none).stages;
  const auto longest = [&](std::string_view name) {
    const auto stage =
        std::find_if(stages.begin(), stages.end(), [&](const StageRun& s) { return s.name == name; });
    return stage == stages.end() ? 0 : static_cast<int>(stage->longest);
  };
  EXPECT_GE(longest("luma"), size.area());
  EXPECT_LT(longest("luma"), longest("frame_ring"));
  EXPECT_GE(longest("gaussian"), longest("difference") + size.width)
      << "the Gaussian waits for the row below";
  EXPECT_LT(longest("gaussian"), longest("binarize"));
  EXPECT_LT(longest("binarize"), longest("polar"));
  EXPECT_LT(longest("polar"), longest("birdseye"));
  EXPECT_LT(longest("birdseye"), longest("cluster"));
}

}  // namespace
}  // namespace floorline::cosim
