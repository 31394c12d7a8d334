/// Random numbers of widths up to 200 bits against SystemC. Seeds are fixed; a failure prints the operands.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ap_fixed.h"
#include "reference.h"

namespace {

using reference::Big;
constexpr int kRounds = 200;

/// Any bit pattern, short numbers and those near the ends of the range as likely as long ones.
template <class T>
T random_number(std::mt19937_64& random) {
  ap_detail::Unsigned<T::width + 64> bits = 0;
  for (int i = 0; i < T::width; i += 64) bits = bits << 64 | random();
  bits >>= random() % (T::width + 64);
  return T(ap_detail::FromBits(), random() % 2 ? bits : ~bits);
}

template <class T>
Big big(const T& x) {
  return static_cast<Big>(ap_detail::raw(x));
}

template <class A, class B>
class IntegerPair {
 public:
  void check(std::mt19937_64& random) {
    const A a = random_number<A>(random);
    const B b = random_number<B>(random);
    SCOPED_TRACE(testing::Message() << a << " (" << A::width << " bits), " << b << " (" << B::width
                                    << " bits)");
    EXPECT_TRUE(big(a + b) == reference::integer(big(a), '+', big(b)));
    EXPECT_TRUE(big(a - b) == reference::integer(big(a), '-', big(b)));
    EXPECT_TRUE(big(a * b) == reference::integer(big(a), '*', big(b)));
    EXPECT_TRUE(big(a & b) == reference::integer(big(a), '&', big(b)));
    EXPECT_TRUE(big(a | b) == reference::integer(big(a), '|', big(b)));
    EXPECT_TRUE(big(a ^ b) == reference::integer(big(a), '^', big(b)));
    if (b != 0) {
      EXPECT_TRUE(big(a / b) == reference::integer(big(a), '/', big(b)));
      EXPECT_TRUE(big(a % b) == reference::integer(big(a), '%', big(b)));
    }
    EXPECT_TRUE(big(B(a)) == reference::wrapped(big(a), B::width, B::sign_flag));
    EXPECT_TRUE(big(A(b)) == reference::wrapped(big(b), A::width, A::sign_flag));
    EXPECT_EQ(a < b, big(a) < big(b));
    EXPECT_EQ(a >= b, big(a) >= big(b));
    EXPECT_EQ(a == b, big(a) == big(b));

    const int distance = static_cast<int>(random() % (A::width + 8));
    EXPECT_TRUE(big(a << distance) == shifted(a, '<', distance));
    EXPECT_TRUE(big(a >> distance) == shifted(a, '>', distance));
    EXPECT_TRUE(big(a << -distance) == shifted(a, '>', distance));

    A c = a;
    c += b;
    EXPECT_TRUE(big(c) == reference::wrapped(big(a) + big(b), A::width, A::sign_flag));
    c *= b;
    c -= a;
    EXPECT_TRUE(big(c) == reference::wrapped((big(a) + big(b)) * big(b) - big(a), A::width, A::sign_flag));
  }

 private:
  static Big shifted(const A& a, char direction, int distance) {
    return reference::wrapped(reference::integer(big(a), direction, distance), A::width, A::sign_flag);
  }
};

template <class Pair>
class WideIntegers : public testing::Test {};
using Pairs = testing::Types<IntegerPair<ap_uint<8>, ap_uint<9>>, IntegerPair<ap_int<13>, ap_uint<12>>,
                             IntegerPair<ap_uint<17>, ap_int<24>>, IntegerPair<ap_int<32>, ap_int<31>>,
                             IntegerPair<ap_uint<33>, ap_uint<48>>, IntegerPair<ap_int<63>, ap_uint<64>>,
                             IntegerPair<ap_int<65>, ap_int<64>>, IntegerPair<ap_uint<80>, ap_uint<127>>,
                             IntegerPair<ap_int<96>, ap_int<128>>, IntegerPair<ap_uint<128>, ap_int<7>>,
                             IntegerPair<ap_int<200>, ap_uint<129>>, IntegerPair<ap_uint<200>, ap_uint<200>>>;
TYPED_TEST_SUITE(WideIntegers, Pairs);

TYPED_TEST(WideIntegers, AgreeWithSystemC) {
  std::mt19937_64 random(1);
  for (int i = 0; i < kRounds && !this->HasFailure(); ++i) TypeParam().check(random);
}

template <class Target, class Source>
class FixedPair {
 public:
  void check(std::mt19937_64& random) {
    const Source source = random_number<Source>(random);
    SCOPED_TRACE(testing::Message() << source.to_double());
    EXPECT_TRUE(big(Target(source)) == expected_.assign(big(source), Source::width - Source::iwidth));
  }

 private:
  reference::Fixed expected_{{Target::width, Target::iwidth, Target::sign_flag},
                             {Target::qmode, Target::omode, 0}};
};

template <class Pair>
class WideFixed : public testing::Test {};
using FixedPairs = testing::Types<FixedPair<ap_fixed<16, 8, AP_RND, AP_SAT>, ap_fixed<40, 12>>,
                                  FixedPair<ap_ufixed<24, 4, AP_RND_CONV, AP_SAT>, ap_fixed<64, 6>>,
                                  FixedPair<ap_fixed<65, 30, AP_RND_CONV, AP_SAT_SYM>, ap_fixed<128, 40>>,
                                  FixedPair<ap_fixed<100, 90, AP_TRN_ZERO, AP_SAT_ZERO>, ap_ufixed<127, 95>>,
                                  FixedPair<ap_ufixed<128, 20, AP_RND_INF, AP_SAT>, ap_fixed<200, 24>>,
                                  FixedPair<ap_fixed<128, 128, AP_RND_ZERO, AP_WRAP>, ap_fixed<160, 130>>,
                                  FixedPair<ap_fixed<33, -3, AP_RND_MIN_INF, AP_SAT>, ap_fixed<90, 0>>,
                                  FixedPair<ap_fixed<48, 60, AP_RND, AP_SAT>, ap_fixed<70, 64>>,
                                  FixedPair<ap_fixed<200, 100>, ap_ufixed<80, 40>>>;
TYPED_TEST_SUITE(WideFixed, FixedPairs);

TYPED_TEST(WideFixed, ConvertAsSystemC) {
  std::mt19937_64 random(2);
  TypeParam pair;
  for (int i = 0; i < 4 * kRounds && !this->HasFailure(); ++i) pair.check(random);
}

/// Significands of every length, exponents far outside the formats.
double random_real(std::mt19937_64& random) {
  const double significand = static_cast<double>(static_cast<long long>(random()) >> random() % 64);
  return std::ldexp(significand, static_cast<int>(random() % 160) - 112);
}

template <class T>
void check_reals() {
  reference::Fixed expected({T::width, T::iwidth, T::sign_flag}, {T::qmode, T::omode, 0});
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const double value = random_real(random);
    ASSERT_EQ(static_cast<long long>(T(value).raw()), expected.assign(value)) << value;
  }
}

TEST(FixedFromDouble, AgreesWithSystemC) {
  check_reals<ap_fixed<32, 12, AP_RND, AP_SAT>>();
  check_reals<ap_fixed<32, 12>>();
  check_reals<ap_ufixed<31, 40, AP_RND_CONV, AP_SAT_ZERO>>();
  check_reals<ap_fixed<8, -6, AP_TRN_ZERO, AP_SAT_SYM>>();
  check_reals<ap_ufixed<32, 0, AP_RND_INF, AP_WRAP>>();
  check_reals<ap_fixed<32, 32, AP_RND_ZERO, AP_SAT>>();
}

TEST(FixedFromDouble, TakesSpecialValues) {
  using Saturating = ap_fixed<8, 4, AP_RND, AP_SAT>;
  EXPECT_EQ(Saturating(INFINITY), 7.9375);
  EXPECT_EQ(Saturating(-INFINITY), -8.0);
  EXPECT_EQ(Saturating(1e308), 7.9375);
  EXPECT_EQ(Saturating(NAN), 0);
  EXPECT_EQ(Saturating(-0.0), 0);
  EXPECT_EQ(Saturating(5e-324), 0);
  EXPECT_EQ((ap_ufixed<8, 4, AP_RND_INF>(0.03125f)), 0.0625);
}

TEST(FixedToDouble, IsExact) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 1000; ++i) {
    const ap_fixed<53, 10> x = random_number<ap_fixed<53, 10>>(random);
    EXPECT_EQ(x, (ap_fixed<53, 10>(x.to_double())));
    EXPECT_EQ(std::ldexp(x.to_double(), 43), static_cast<double>(static_cast<long long>(x.raw())));
  }
}

}  // namespace
