/// + - * / and comparison of fixed-point numbers for all pairs of widths up to 6 bits, both signs, every
/// value and several places of the points, against SystemC's exact values.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ap_fixed.h"
#include "reference.h"

namespace {

template <int W, int I, bool S>
using Fixed = typename std::conditional<S, ap_fixed<W, I>, ap_ufixed<W, I>>::type;

struct Operand {
  int width, fraction;
  bool is_signed;

  double value(int bits) const {
    return std::ldexp(is_signed && bits >> (width - 1) ? bits - (1 << width) : bits, -fraction);
  }
};

struct Results {
  double plus, minus, times, quotient;
  std::string order;  ///< One digit for each of == < >=.
};

template <class A, class B>
Results evaluate(int a_bits, int b_bits) {
  const A a(ap_detail::FromBits(), a_bits);
  const B b(ap_detail::FromBits(), b_bits);
  const B divisor(ap_detail::FromBits(), b_bits ? b_bits : 1);
  return {(a + b).to_double(),
          (a - b).to_double(),
          (a * b).to_double(),
          (a / divisor).to_double(),
          {char('0' + (a == b)), char('0' + (a < b)), char('0' + (a >= b))}};
}

void check(Operand left, Operand right, reference::Format quotient_format, Results (*evaluate)(int, int)) {
  reference::Fixed exact({40, 20, true}, {AP_TRN, AP_SAT, 0});
  reference::Fixed quotient(quotient_format, {AP_TRN_ZERO, AP_WRAP, 0});
  for (int i = 0; i < 1 << left.width; ++i) {
    for (int j = 0; j < 1 << right.width; ++j) {
      const double a = left.value(i), b = right.value(j);
      SCOPED_TRACE(testing::Message()
                   << a << " (" << left.width << " bits) and " << b << " (" << right.width << ")");
      const Results r = evaluate(i, j);
      ASSERT_EQ(std::ldexp(r.plus, 20), exact.assign(a, '+', b));
      ASSERT_EQ(std::ldexp(r.minus, 20), exact.assign(a, '-', b));
      ASSERT_EQ(std::ldexp(r.times, 20), exact.assign(a, '*', b));
      ASSERT_EQ(r.order, std::string({char('0' + (a == b)), char('0' + (a < b)), char('0' + (a >= b))}));
      if (b != 0) {
        ASSERT_EQ(std::ldexp(r.quotient, quotient_format.width - quotient_format.integer),
                  quotient.assign(a, '/', b));
      }
    }
  }
}

template <int W1, int F1, bool S1, int W2, int F2, bool S2>
void check_pair() {
  using A = Fixed<W1, W1 - F1, S1>;
  using B = Fixed<W2, W2 - F2, S2>;
  // The quotient as published: as many fraction bits as the dividend has, more when the divisor has integer
  // zeros.
  const int width = W1 + (F2 > 0 ? F2 : 0) + S2, integer = W1 - F1 + F2 + S2;
  check({W1, F1, S1}, {W2, F2, S2}, {width, integer, S1 || S2}, evaluate<A, B>);
}

template <int F1, int F2, int W1, bool S1, bool S2, int... W2>
void check_right() {
  (check_pair<W1, F1, S1, W2, F2, S2>(), ...);
}
template <bool S1, bool S2, int... W1>
void check_left() {
  (check_right<2, 2, W1, S1, S2, 1, 2, 3, 4, 5, 6>(), ...);
}
/// The points apart, and outside both words.
template <bool S1, bool S2>
void check_points() {
  check_right<0, 3, 4, S1, S2, 1, 4, 6>();
  check_right<5, 1, 6, S1, S2, 1, 4, 6>();
  check_right<8, -3, 1, S1, S2, 1, 4, 6>();
  check_right<-2, 9, 4, S1, S2, 1, 4, 6>();
}

TEST(FixedArithmetic, UnsignedUnsigned) { check_left<false, false, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedArithmetic, UnsignedSigned) { check_left<false, true, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedArithmetic, SignedUnsigned) { check_left<true, false, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedArithmetic, SignedSigned) { check_left<true, true, 1, 2, 3, 4, 5, 6>(); }
TEST(FixedArithmetic, PointsApart) {
  check_points<false, false>();
  check_points<false, true>();
  check_points<true, false>();
  check_points<true, true>();
}

}  // namespace
