#include "tb/cosim/port_watch.h"

#include <gtest/gtest.h>

namespace floorline::cosim {
namespace {

/// An element passes `points` in every third cycle; its data is the cycle.
void run(PortWatch& watch, std::uint32_t cycles) {
  for (std::uint32_t cycle = 0; cycle < cycles; ++cycle) {
    PortCycle now = {cycle, {}};
    now.ports[index(Port::points)] = {true, cycle % 3 == 0, {cycle}};
    watch.see(now);
  }
}

TEST(PortWatch, KeepsTheCyclesAroundTheElement) {
  PortWatch watch(Port::points, 10);
  run(watch, 100);
  ASSERT_TRUE(watch.passed());
  EXPECT_EQ(watch.cycles()[watch.passed_at()].cycle, 30u);
  EXPECT_EQ(watch.cycles().front().cycle, 30 - PortWatch::kBefore);
  EXPECT_EQ(watch.cycles().back().cycle, 30 + PortWatch::kAfter);
}

TEST(PortWatch, StartsAtTheFirstCycleWhenTheElementComesSoon) {
  PortWatch watch(Port::points, 0);
  run(watch, 100);
  EXPECT_EQ(watch.passed_at(), 0u);
  EXPECT_EQ(watch.cycles().size(), 1 + PortWatch::kAfter);
}

TEST(PortWatch, KeepsTheLastCyclesWhenTheElementNeverComes) {
  PortWatch watch(Port::obstacles, 0);
  run(watch, 100);
  EXPECT_FALSE(watch.passed());
  EXPECT_EQ(watch.cycles().size(), PortWatch::kBefore + 1);
  EXPECT_EQ(watch.cycles().back().cycle, 99u);
}

}  // namespace
}  // namespace floorline::cosim
