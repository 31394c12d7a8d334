/// Result types of the operators as published for Vitis HLS, and what converts to what. Built as C++11, 14,
/// 17 and 20.
#include <gtest/gtest.h>

#include "ap_axi_sdata.h"
#include "ap_fixed.h"
#include "ap_int.h"
#include "ap_shift_reg.h"
#include "hls_stream.h"

namespace {

#define EXPECT_TYPE(expression, ...) static_assert(std::is_same<decltype(expression), __VA_ARGS__>::value, "")

typedef ap_int<8> I8;
typedef ap_uint<8> U8;
typedef ap_uint<6> U6;
typedef ap_int<6> I6;

// + and - grow by one bit, and by one more when only the other operand is signed; - is always signed.
EXPECT_TYPE(U8() + U6(), ap_uint<9>);
EXPECT_TYPE(I8() + I6(), ap_int<9>);
EXPECT_TYPE(U8() + I6(), ap_int<10>);
EXPECT_TYPE(I8() + U6(), ap_int<9>);
EXPECT_TYPE(I8() + U8(), ap_int<10>);
EXPECT_TYPE(U8() - U6(), ap_int<9>);
EXPECT_TYPE(I6() - U8(), ap_int<10>);
EXPECT_TYPE(U8() * I6(), ap_int<14>);
EXPECT_TYPE(U8() * U6(), ap_uint<14>);
EXPECT_TYPE(U8() / U6(), ap_uint<8>);
EXPECT_TYPE(U8() / I6(), ap_int<9>);
EXPECT_TYPE(I8() / U6(), ap_int<8>);
EXPECT_TYPE(U8() % U6(), ap_uint<6>);
EXPECT_TYPE(I8() % U6(), ap_int<7>);
EXPECT_TYPE(U6() % I8(), ap_uint<6>);
EXPECT_TYPE(U8() & U6(), ap_uint<8>);
EXPECT_TYPE(U8() | I6(), ap_int<9>);
EXPECT_TYPE(I8() ^ U8(), ap_int<9>);
EXPECT_TYPE(U8() << I6(), U8);
EXPECT_TYPE(I8() >> 3, I8);
EXPECT_TYPE(-U8(), ap_int<9>);
EXPECT_TYPE(-I8(), ap_int<9>);
EXPECT_TYPE(-ap_int<1>(), ap_int<3>);
EXPECT_TYPE(~U8(), ap_int<9>);
EXPECT_TYPE(~I8(), ap_int<8>);

// Native integers count with their width.
EXPECT_TYPE(U8() + 1, ap_int<33>);
EXPECT_TYPE(1u + U8(), ap_uint<33>);
EXPECT_TYPE(I8() * 1LL, ap_int<72>);
EXPECT_TYPE(true + U8(), ap_uint<9>);
EXPECT_TYPE(U8() + 'a', ap_int<10>);
EXPECT_TYPE((short)1 - U8(), ap_int<17>);
EXPECT_TYPE(1 << U6(), ap_int<32>);
EXPECT_TYPE(U8() == 1, bool);
EXPECT_TYPE(U8() * 2.0, double);

typedef ap_fixed<8, 3> F83;
typedef ap_ufixed<10, 6> UF106;
EXPECT_TYPE(F83() + F83(), ap_fixed<9, 4>);
EXPECT_TYPE(F83() + UF106(), ap_fixed<13, 8>);
EXPECT_TYPE(UF106() - UF106(), ap_fixed<11, 7>);
EXPECT_TYPE(F83() * UF106(), ap_fixed<18, 9>);
EXPECT_TYPE(F83() / F83(), ap_fixed<14, 9>);
EXPECT_TYPE(UF106() / F83(), ap_fixed<16, 12>);
EXPECT_TYPE((F83() / ap_ufixed<4, 6>()), ap_fixed<8, 1>);
EXPECT_TYPE(F83() & UF106(), ap_fixed<12, 7>);
EXPECT_TYPE(F83() + 1, ap_fixed<38, 33>);
EXPECT_TYPE(U8() * F83(), ap_fixed<16, 11>);
EXPECT_TYPE(-UF106(), ap_fixed<11, 7>);
EXPECT_TYPE((ap_fixed<8, 3, AP_RND, AP_SAT>() << 1), ap_fixed<8, 3, AP_RND, AP_SAT>);
EXPECT_TYPE((ap_fixed<8, 3, AP_RND, AP_SAT>() + F83()), ap_fixed<9, 4>);

// A register: as large as its bits, copied by memory, uninitialised by default, a constant when made of
// constants.
static_assert(std::is_trivially_copyable<F83>::value && std::is_trivial<U8>::value, "");
static_assert(sizeof(U8) == 1 && sizeof(ap_int<24>) == 4 && sizeof(ap_uint<128>) == 16, "");
constexpr ap_fixed<12, 2, AP_RND, AP_SAT> kHalf = 0.5;
static_assert(kHalf == 0.5 && U8(300) == 44 && ap_int<4>(-9.9) == 7, "");
static_assert(!std::is_copy_constructible<hls::stream<int>>::value, "");

// Vitis names the parts of an AXI4-Stream element; channels of width 0 are there to be assigned and cost
// nothing.
typedef ap_axiu<24, 1, 2, 3> Element;
EXPECT_TYPE(Element::data, ap_uint<24>);
typedef ap_axis<17> SignedElement;
EXPECT_TYPE(SignedElement::data, ap_int<17>);
EXPECT_TYPE(Element::keep, ap_uint<3>);
EXPECT_TYPE(SignedElement::strb, ap_uint<3>);
EXPECT_TYPE(Element::user, ap_uint<1>);
EXPECT_TYPE(Element::id, ap_uint<2>);
EXPECT_TYPE(Element::dest, ap_uint<3>);
EXPECT_TYPE(SignedElement::last, ap_uint<1>);
typedef hls::axis<float, 0, 0, 0> FloatElement;
EXPECT_TYPE(FloatElement::keep, ap_uint<4>);

enum Mode { kIdle, kRun = 3 };

#define STANDARD_NAME_(standard) Cxx##standard
#define STANDARD_NAME(standard) STANDARD_NAME_(standard)
#define Types STANDARD_NAME(TYPES_CXX_STANDARD)

TEST(Types, MixWithNativeNumbers) {
  U8 x = 200;
  int i = x;
  i += x;
  EXPECT_EQ(i, 400);
  EXPECT_TRUE(i > x && 100 < x && x != i && x >= 200u && 200LL == x);
  EXPECT_TRUE(U8(3) == kRun && kIdle < x);
  int table[4] = {1, 2, 3, 4};
  EXPECT_EQ(table[ap_uint<2>(2)], 3);
  switch (ap_uint<2>(3)) {
    case kRun:
      i = 1;
      break;
    default:
      i = 0;
  }
  EXPECT_EQ(i, 1);
  const double d = x;
  EXPECT_EQ(d, 200.0);
  EXPECT_TRUE(x ? true : false);
  EXPECT_FALSE(!x);
  x += 100;
  EXPECT_EQ(x, 44);
  x <<= 1;
  x -= kRun;
  x /= 5;
  x %= 10;
  EXPECT_EQ(x++, 7);
  EXPECT_EQ(--x, 7);
  x = -1;
  EXPECT_EQ(x, 255);
  EXPECT_EQ(++x, 0);
}

TEST(Types, ConvertBetweenIntegersAndFixed) {
  const ap_fixed<8, 4> x = -2.75;
  EXPECT_EQ(ap_int<8>(x), -2);  // towards zero, as from double
  EXPECT_EQ(x.to_int(), -2);
  EXPECT_EQ(int(x), -2);
  EXPECT_EQ(double(x), -2.75);
  EXPECT_EQ(float(x), -2.75f);
  EXPECT_EQ((ap_int<12>(ap_fixed<4, 8>(-128))), -128);
  EXPECT_EQ((ap_int<12>(ap_fixed<4, -2>(-0.03125))), 0);
  EXPECT_TRUE(x < -2 && x == -2.75 && -3.0 < x && 1 > x);
  ap_fixed<8, 4> y = ap_uint<3>(5);
  y *= x;
  EXPECT_EQ(y, 2.25);  // -13.75 wraps
  y++;
  EXPECT_EQ(y, 3.25);
  y >>= 2;
  EXPECT_EQ(y, 0.8125);
  if (y) y = 0;
  EXPECT_TRUE(!y);
}

TEST(Types, AxiElementsHoldSideChannels) {
  ap_axiu<24, 1, 0, 0> pixel;
  pixel.data = 0x123456;
  pixel.user = 1;
  pixel.id = 7;
  pixel.dest = 7;
  const ap_axiu<24, 1, 0, 0> copy = pixel;
  EXPECT_EQ(copy.data, 0x123456);
  EXPECT_EQ(copy.user, 1);
  EXPECT_EQ(copy.id, 0u);
}

TEST(Types, ShiftRegisterReadsThenShifts) {
  static ap_shift_reg<int, 4> line;
  for (int i = 1; i <= 4; ++i) line.shift(i);
  EXPECT_EQ(line.read(0), 4);
  EXPECT_EQ(line.read(), 1);
  EXPECT_EQ(line.shift(5, 1), 3);
  EXPECT_EQ(line.shift(6, 0, false), 5);
  EXPECT_EQ(line.read(3), 2);
}

}  // namespace
