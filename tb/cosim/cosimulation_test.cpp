/// Every bit of the whole accelerator in Verilog against the C simulation.
#include "tb/cosim/cosimulation.h"

#include <gtest/gtest.h>

#include "tb/cosim/random_frames.h"

namespace floorline::cosim {
namespace {

/// Expects no difference; tells the first one and where its waves are.
Result expect_equal(Job job) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::string file = "waves_" + test + ".fst";
  std::replace(file.begin(), file.end(), '/', '_');
  job.waves = file;
  Result result = cosimulate(job);
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    const FrameVerdict& frame = result.frames[i];
    EXPECT_EQ(frame.differences(), 0)
        << "frame " << i << ": " << frame.first_difference->words << "; waves in " << file;
    if (frame.differences() != 0) break;
  }
  EXPECT_EQ(result.frames.size(), static_cast<std::size_t>(job.frame_count));
  return result;
}

class Cosimulation : public testing::TestWithParam<Stalls> {};

/// Sizes, lines and every parameter change from frame to frame; references are held, replaced and dropped.
TEST_P(Cosimulation, ParametersChangeFromFrameToFrame) {
  constexpr int kFrames = 60;
  constexpr std::uint64_t kSeed = 5;
  RandomFrames random(kSeed);
  const auto frame = [&](int index) {
    if (index == 0) random = RandomFrames(kSeed);
    if (index == 0 || random.chance(0.15)) random.begin_scene(random.size({96, 64}));
    return random.next();
  };
  const Result result = expect_equal({{640, 480}, kFrames, frame, GetParam(), kSeed, {}, {}});
  std::size_t points = 0;
  for (const FrameVerdict& verdict : result.frames) points += verdict.point_count;
  EXPECT_GT(points, 50u) << "the frames must show something to compare";
}

TEST_P(Cosimulation, FullSize) {
  RandomFrames random(11);
  const cv::Size size(640, 480);
  const std::vector<LineSetup> lines = random.lines(size);
  ASSERT_FALSE(lines.empty());
  const auto frame = [&](int index) {
    if (index == 0) random = RandomFrames(12);
    return FrameInput{random.image(size), random.parameters(size), lines};
  };
  expect_equal({size, 3, frame, GetParam(), 3, {}, {}});
}

/// The start of the soak (record.cpp): scenes of few grey levels among them, where thresholds tie.
TEST(CosimulationOfScenes, ManySmallOnes) {
  constexpr int kFrames = 400;
  constexpr std::uint64_t kSeed = 99;
  RandomFrames random(kSeed);
  const auto frame = [&](int index) {
    if (index == 0) random = RandomFrames(kSeed);
    if (index == 0 || random.chance(0.1)) random.begin_scene(random.size({64, 48}));
    return random.next();
  };
  expect_equal({{640, 480}, kFrames, frame, Stalls::light, kSeed, {}, {}});
}

INSTANTIATE_TEST_SUITE_P(stalls, Cosimulation, testing::Values(Stalls::none, Stalls::light, Stalls::heavy),
                         [](const auto& info) { return name(info.param); });

}  // namespace
}  // namespace floorline::cosim
