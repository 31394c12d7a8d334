/// Numbers to text and back.
#include <gtest/gtest.h>

#include <sstream>

#include "ap_fixed.h"
#include "ap_int.h"

namespace {

template <class T>
std::string printed(const T& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

TEST(Text, IntegersInEveryRadix) {
  EXPECT_EQ(ap_int<8>(-5).to_string(10), "-5");
  EXPECT_EQ(ap_int<8>(-128).to_string(10), "-128");
  EXPECT_EQ(ap_uint<9>(0x1f).to_string(16), "0x1f");
  EXPECT_EQ(ap_uint<4>(5).to_string(), "0b101");
  EXPECT_EQ(ap_uint<6>(0).to_string(8), "0o0");
  EXPECT_EQ((ap_uint<100>(1) << 99).to_string(10), "633825300114114700748351602688");
  EXPECT_EQ(ap_int<8>(-5).to_string(10, false), "251");
}

TEST(Text, IntegersAreRead) {
  EXPECT_EQ(ap_int<8>("-12"), -12);
  EXPECT_EQ(ap_uint<8>("0x1f"), 31);
  EXPECT_EQ(ap_uint<8>("1F", 16), 31);
  EXPECT_EQ(ap_uint<8>("0b101"), 5);
  EXPECT_EQ(ap_uint<8>("101", 2), 5);
  EXPECT_EQ(ap_uint<100>("633825300114114700748351602688"), ap_uint<100>(1) << 99);
  EXPECT_EQ(ap_uint<4>("17"), 1);
  EXPECT_THROW(ap_uint<8>("12a"), std::invalid_argument);
  EXPECT_THROW(ap_uint<8>("2", 2), std::invalid_argument);
}

TEST(Text, StreamsPrintAndRead) {
  EXPECT_EQ(printed(ap_uint<8>(65)), "65");
  EXPECT_EQ(printed(ap_int<8>(-65)), "-65");
  EXPECT_EQ(printed(ap_uint<8>(0x65).range(7, 4)), "6");
  EXPECT_EQ(printed(ap_uint<8>(1)[0]), "1");
  std::ostringstream hex;
  hex << std::hex << ap_uint<8>(255);
  EXPECT_EQ(hex.str(), "0xff");
  std::istringstream in("-7 300");
  ap_int<8> x, y;
  in >> x >> y;
  EXPECT_EQ(x, -7);
  EXPECT_EQ(y, 44);
}

TEST(Text, FixedPointIsExact) {
  EXPECT_EQ(printed(ap_fixed<8, 4>(-2.6875)), "-2.6875");
  EXPECT_EQ(printed(ap_fixed<8, 4>(-8)), "-8");
  EXPECT_EQ(printed(ap_ufixed<4, 8>(48)), "48");
  EXPECT_EQ(printed(ap_fixed<4, -2>(-0.03125)), "-0.03125");
  EXPECT_EQ((ap_fixed<8, 4>(2.5).to_string()), "0b10.1");
  EXPECT_EQ((ap_fixed<12, 4>(2.5).to_string(16)), "0x2.8");
  EXPECT_EQ((ap_fixed<8, 4>("-2.5")), -2.5);
  EXPECT_EQ((ap_fixed<8, 4>("0x1.8")), 1.5);
}

}  // namespace
