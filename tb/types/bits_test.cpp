/// Bits, slices, concatenations, reductions and rotations, against the plain definition of each.
#include <gtest/gtest.h>

#include "ap_fixed.h"
#include "ap_int.h"

namespace {

TEST(Bits, ReadAndWriteOneBit) {
  ap_uint<8> x = 0x81;
  EXPECT_TRUE(x[0] && x[7] && !x[3] && x.test(7) && x.get_bit(0) && x.bit(7));
  x[3] = true;
  x[7] = x[1];
  EXPECT_EQ(x, 0x09);
  x.set(1);
  x.set(0, false);
  x.clear(3);
  x.invert(6);
  EXPECT_EQ(x, 0x42);
  x.set_bit(0, true);
  x[1] = ~x[1];
  EXPECT_EQ(x, 0x41);
  x.b_not();
  EXPECT_EQ(x, 0xbe);
  EXPECT_EQ(x[1] + x[2], 2);
  EXPECT_EQ(x[0] ^ x[1], 1);
  x.set();
  EXPECT_EQ(x, 0xff);
  x.clear();
  EXPECT_EQ(x, 0);
  EXPECT_TRUE(ap_int<8>(-1).sign() && !ap_uint<8>(255).sign());
  EXPECT_EQ(ap_uint<70>(0).length(), 70);
}

TEST(Bits, ReadEverySlice) {
  const ap_int<12> x = 0xa5c - 0x1000;
  for (int hi = 0; hi < 12; ++hi)
    for (int lo = 0; lo <= hi; ++lo) {
      const unsigned expected = 0xa5cu >> lo & ((1u << (hi - lo + 1)) - 1);
      EXPECT_EQ(x.range(hi, lo), expected);
      EXPECT_EQ(x(ap_uint<4>(hi), ap_uint<4>(lo)), expected);
      EXPECT_EQ(x.range(hi, lo).length(), hi - lo + 1);
    }
  EXPECT_EQ(x.range(), 0xa5c);
}

TEST(Bits, WriteEverySlice) {
  for (int hi = 0; hi < 12; ++hi)
    for (int lo = 0; lo <= hi; ++lo) {
      ap_uint<12> x = 0xa5c;
      x.range(hi, lo) = 0x963;
      const unsigned mask = ((1u << (hi - lo + 1)) - 1) << lo;
      EXPECT_EQ(x, (0xa5cu & ~mask) | (0x963u << lo & mask));
    }
}

TEST(Bits, SlicesAreValues) {
  ap_uint<16> x = 0x1234, y = 0xabcd;
  x.range(7, 0) = y.range(15, 8);
  EXPECT_EQ(x, 0x12ab);
  x(15, 8) = x(7, 0);
  EXPECT_EQ(x, 0xabab);
  EXPECT_EQ(y.range(3, 0) + y.range(7, 4), 0xd + 0xc);
  EXPECT_TRUE(y.range(15, 12) == 0xa && y.range(15, 12) > y.range(3, 0) - 4);
  EXPECT_EQ(y.range(7, 4).to_int() + y(3, 0).to_uint(), 25u);
  EXPECT_EQ(ap_int<4>(y.range(3, 0)), -3);
  EXPECT_TRUE(x.range(0, 0).and_reduce() && !y.range(1, 0).and_reduce() && y.range(1, 0).xor_reduce());
  const ap_uint<100> wide = ap_uint<100>(5) << 90;
  EXPECT_EQ(wide.range(92, 90), 5);
}

TEST(Bits, ConcatenateValues) {
  ap_uint<4> a = 0xa;
  const ap_int<8> b = -1;
  EXPECT_EQ((a, b), 0xaff);
  EXPECT_EQ((a, b).length(), 12);
  EXPECT_EQ((b, a, ap_uint<2>(1)), 0x3fe9);
  EXPECT_EQ(b.concat(a), 0xffa);
  EXPECT_EQ((a[3], a[0], b(1, 0)), 0xb);
  EXPECT_EQ(ap_uint<6>((b.range(2, 1), a)), 0x3a);
  static_assert(decltype((a, b))::width == 12);
  // The user guide's example.
  ap_int<3> v1 = -3;
  ap_int<7> v2 = 54;
  EXPECT_EQ(ap_uint<10>((v2, v1)), 0x1b5);
  EXPECT_EQ(ap_uint<10>(v1.concat(v2)), 0x2b6);
}

TEST(Bits, ConcatenationsAreTargets) {
  ap_int<3> v1;
  ap_int<7> v2;
  (v1, v2) = 0xab;
  EXPECT_EQ(v1, 1);
  EXPECT_EQ(v2, 43);
  ap_uint<8> x = 0, y = 0;
  (x(7, 4), y[0], x(1, 0)) = 0x5f;
  EXPECT_EQ(x, 0xb3);
  EXPECT_EQ(y, 1);
  (x, y) = (y, x);
  EXPECT_EQ(x, 1);
  EXPECT_EQ(y, 0xb3);
}

TEST(Bits, ReduceEveryValue) {
  for (int i = 0; i < 128; ++i) {
    const ap_uint<7> x = i;
    const int ones = __builtin_popcount(i);
    EXPECT_EQ(x.and_reduce(), ones == 7);
    EXPECT_EQ(x.nand_reduce(), ones != 7);
    EXPECT_EQ(x.or_reduce(), ones > 0);
    EXPECT_EQ(x.nor_reduce(), ones == 0);
    EXPECT_EQ(x.xor_reduce(), ones % 2 == 1);
    EXPECT_EQ(x.xnor_reduce(), ones % 2 == 0);
    EXPECT_EQ(x.countLeadingZeros(), i ? __builtin_clz(i) - 25 : 7);
  }
}

TEST(Bits, ReverseAndRotateEveryValue) {
  for (int i = 0; i < 128; ++i) {
    ap_uint<7> reversed = i;
    reversed.reverse();
    for (int k = 0; k < 7; ++k) EXPECT_EQ(bool(reversed[k]), (i >> (6 - k) & 1) != 0);
    for (int n = 0; n < 7; ++n) {
      ap_int<7> left = i, right = i;
      left.lrotate(n);
      right.rrotate(n);
      EXPECT_EQ(left.range(), (i << n | i >> (7 - n)) & 127);
      EXPECT_EQ(right.range(), (i >> n | i << (7 - n)) & 127);
    }
  }
}

TEST(Bits, FixedPointCountsFromItsPoint) {
  ap_fixed<8, 4> x = 2.5;
  EXPECT_TRUE(x.get_bit(1) && x.get_bit(-1) && !x.get_bit(0));
  x.set_bit(-2, true);
  EXPECT_EQ(x, 2.75);
  EXPECT_EQ(x.range(7, 4), 2);
  EXPECT_EQ(x[2], 1);
  x.range() = 0xf0;
  EXPECT_EQ(x, -1);
  EXPECT_EQ(~x, 0.9375);
}

TEST(BitsDeathTest, OutsideTheValueStops) {
  ap_uint<8> x = 0;
  EXPECT_DEATH(x[8] = true, "bit: index 8 is outside 0..7");
  EXPECT_DEATH((void)x.range(8, 0).to_int(), "range");
  EXPECT_DEATH((void)x.range(0, 3).to_int(), "range length");
}

}  // namespace
