/// Malformed streams and stray register accesses, more than a hundred with every kind of stalls.
#include "tb/cosim/fault_campaign.h"

#include <gtest/gtest.h>

namespace floorline::cosim {
namespace {

class Faults : public testing::TestWithParam<Stalls> {};

TEST_P(Faults, NeitherHangTheCoreNorReachTheNextGoodFrame) {
  constexpr int kRounds = 4;
  FaultCampaign campaign(GetParam(), 21);
  for (int round = 0; round < kRounds; ++round) {
    for (int kind = 0; kind < kFaultKinds; ++kind) campaign.inject(static_cast<Fault>(kind));
  }
  const FaultTally& tally = campaign.tally();
  EXPECT_EQ(tally.injected, kRounds * kFaultKinds);
  EXPECT_EQ(tally.hung, 0) << tally.first;
  EXPECT_EQ(tally.wrong_frames, 0) << tally.first;
  EXPECT_EQ(tally.uncounted, 0) << tally.first;
}

INSTANTIATE_TEST_SUITE_P(stalls, Faults, testing::Values(Stalls::none, Stalls::light, Stalls::heavy));

}  // namespace
}  // namespace floorline::cosim
