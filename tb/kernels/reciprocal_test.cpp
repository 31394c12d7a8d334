#include "hls/reciprocal.h"

#include <cmath>

#include "image_stream.h"

namespace floorline {
namespace {

double value(const Reciprocal& reciprocal) {
  return std::ldexp(reciprocal.mantissa.to_double(), 4 - 17 - reciprocal.shift.to_int());
}

/// Z in Q4.28.
double value(ap_int<32> z) { return std::ldexp(z.to_double(), -28); }

TEST(Reciprocal, RelativeErrorIsBelow2ToTheMinus16) {
  double worst = 0;
  for (long z = (1L << 24) + 1; z < (1L << 31); z += z >> 19 | 1) {
    const Reciprocal found = reciprocal(z - 1);
    ASSERT_TRUE(found.valid);
    worst = std::max(worst, std::abs(value(found) * value(ap_int<32>(z)) - 1));
  }
  expect_figure("reciprocal_relative_error", worst, std::ldexp(1, -16));
}

TEST(Reciprocal, IsExactAtPowersOfTwo) {
  for (int e = -3; e <= 2; ++e) {
    const long z = 1L << (28 + e);
    EXPECT_EQ(value(reciprocal(z - 1)), std::ldexp(1, -e));
  }
}

TEST(Reciprocal, IsValidBetweenASixteenthAndEight) {
  EXPECT_FALSE(reciprocal(-1).valid);
  EXPECT_FALSE(reciprocal(-(1 << 28)).valid);
  EXPECT_FALSE(reciprocal((1 << 24) - 1).valid);
  EXPECT_TRUE(reciprocal(1 << 24).valid);
  EXPECT_TRUE(reciprocal(0x7fffffff).valid);
}

TEST(Reciprocal, QuotientRoundsDown) {
  const Reciprocal half = reciprocal((2 << 28) - 1);
  EXPECT_EQ(quotient<13>(11, half).to_int(), 5);
  EXPECT_EQ(quotient<13>(-11, half).to_int(), -6);
  EXPECT_EQ(quotient<10>(11, half).to_int(), 44);
}

}  // namespace
}  // namespace floorline
