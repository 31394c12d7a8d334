#include "tb/cosim/comparison.h"

#include <gtest/gtest.h>

namespace floorline::cosim {
namespace {

const std::vector<PackedElement> kExpected = {{1}, {2}, {3}};

TEST(Comparison, CountsBitsAndTellsTheFirstElement) {
  std::optional<Difference> first;
  EXPECT_EQ(compare(Port::points, kExpected, false, {.elements = {{1}, {2}, {3}}}, first), 0);
  EXPECT_FALSE(first);
  EXPECT_EQ(compare(Port::points, kExpected, false, {.elements = {{1}, {1}, {0}}}, first), 2 + 2);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->port, Port::points);
  EXPECT_EQ(first->element, 1u);
  EXPECT_NE(first->words.find("points[1] of 3"), std::string::npos) << first->words;
  compare(Port::counts, kExpected, false, {.elements = {{0}, {2}, {3}}}, first);
  EXPECT_EQ(first->port, Port::points) << "what was first stays";
}

TEST(Comparison, AMissingElementCountsAsAWhole) {
  std::optional<Difference> first;
  EXPECT_EQ(compare(Port::counts, kExpected, false, {.elements = {{1}, {2}}}, first), 128 - 2);
  EXPECT_EQ(first->element, 1u) << "the last one that came";
}

TEST(Comparison, TheMarkOfAMalformedFrameIsABit) {
  std::optional<Difference> first;
  EXPECT_EQ(compare(Port::obstacles, kExpected, true, {.elements = kExpected, .malformed = false}, first), 1);
  EXPECT_EQ(first->element, 2u);
}

TEST(Comparison, TapsAreComparedElementByElement) {
  CSimulation csim({64, 48});
  const cv::Mat image(16, 16, CV_8UC1, cv::Scalar(9));
  FrameParameters parameters = {};
  parameters.width = parameters.height = 16;
  parameters.grey = 1;
  const ExpectedFrame expected(csim, image, parameters, {});
  TapElements got;
  for (std::size_t i = 0; i < kTapCount; ++i)
    got[i].assign(expected.taps[i].begin<uchar>(), expected.taps[i].end<uchar>());
  got[2][5] ^= 3;
  got[3].pop_back();
  std::optional<Difference> first;
  EXPECT_EQ(compare_taps(expected, got, first), 2 + 8);
  EXPECT_EQ(first->port, Port::blurred);
  EXPECT_EQ(first->element, 5u);
  EXPECT_TRUE(got[0].empty()) << "compared elements are taken out";
}

}  // namespace
}  // namespace floorline::cosim
