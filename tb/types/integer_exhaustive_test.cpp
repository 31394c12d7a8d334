/// Every operator of ap_int and ap_uint for all pairs of widths up to 6 bits, both signs, every value,
/// against SystemC.
#include <gtest/gtest.h>

#include <string>

#include "ap_int.h"
#include "reference.h"

namespace {

template <int W, bool S>
using Integer = typename std::conditional<S, ap_int<W>, ap_uint<W>>::type;

struct Operand {
  int width;
  bool is_signed;

  long long value(int bits) const { return is_signed && bits >> (width - 1) ? bits - (1 << width) : bits; }
  long long wrap(long long x) const { return reference::wrapped(x, width, is_signed); }
};

struct Results {
  long long plus, minus, times, bit_and, bit_or, bit_xor, left, right, assigned, negated, inverted;
  long long quotient, remainder;  ///< Only of a divisor that is not 0.
  std::string order;              ///< One digit for each of == != < <= > >=.
};

template <class A, class B>
std::string order(const A& a, const B& b) {
  return {char('0' + (a == b)), char('0' + (a != b)), char('0' + (a < b)),
          char('0' + (a <= b)), char('0' + (a > b)),  char('0' + (a >= b))};
}

template <int W1, bool S1, int W2, bool S2>
Results evaluate(int a_bits, int b_bits) {
  const Integer<W1, S1> a(ap_detail::FromBits(), a_bits);
  const Integer<W2, S2> b(ap_detail::FromBits(), b_bits);
  Results r;
  r.plus = a + b;
  r.minus = a - b;
  r.times = a * b;
  r.bit_and = a & b;
  r.bit_or = a | b;
  r.bit_xor = a ^ b;
  r.left = a << b;
  r.right = a >> b;
  r.assigned = Integer<W2, S2>(a);
  r.negated = -a;
  r.inverted = ~a;
  r.quotient = b == 0 ? 0 : static_cast<long long>(a / (b == 0 ? decltype(b)(1) : b));
  r.remainder = b == 0 ? 0 : static_cast<long long>(a % (b == 0 ? decltype(b)(1) : b));
  r.order = order(a, b);
  return r;
}

void check(Operand left, Operand right, Results (*evaluate)(int, int)) {
  for (int i = 0; i < 1 << left.width; ++i) {
    for (int j = 0; j < 1 << right.width; ++j) {
      const long long a = left.value(i), b = right.value(j);
      SCOPED_TRACE(testing::Message()
                   << a << " (" << left.width << " bits) and " << b << " (" << right.width << ")");
      const Results r = evaluate(i, j);
      ASSERT_EQ(r.plus, reference::integer(a, '+', b));
      ASSERT_EQ(r.minus, reference::integer(a, '-', b));
      ASSERT_EQ(r.times, reference::integer(a, '*', b));
      ASSERT_EQ(r.bit_and, reference::integer(a, '&', b));
      ASSERT_EQ(r.bit_or, reference::integer(a, '|', b));
      ASSERT_EQ(r.bit_xor, reference::integer(a, '^', b));
      ASSERT_EQ(r.left,
                left.wrap(reference::integer(a, b < 0 ? '>' : '<', std::abs(b) < 7 ? std::abs(b) : 7)));
      ASSERT_EQ(r.right,
                left.wrap(reference::integer(a, b < 0 ? '<' : '>', std::abs(b) < 7 ? std::abs(b) : 7)));
      ASSERT_EQ(r.assigned, right.wrap(a));
      ASSERT_EQ(r.negated, -a);
      ASSERT_EQ(r.inverted, ~a);
      ASSERT_EQ(r.order, order(a, b));
      if (b != 0) {
        ASSERT_EQ(r.quotient, reference::integer(a, '/', b));
        ASSERT_EQ(r.remainder, reference::integer(a, '%', b));
      }
    }
  }
}

template <int W1, bool S1, bool S2, int... W2>
void check_right() {
  (check({W1, S1}, {W2, S2}, evaluate<W1, S1, W2, S2>), ...);
}
template <bool S1, bool S2, int... W1>
void check_left() {
  (check_right<W1, S1, S2, 1, 2, 3, 4, 5, 6>(), ...);
}

TEST(IntegerExhaustive, UnsignedUnsigned) { check_left<false, false, 1, 2, 3, 4, 5, 6>(); }
TEST(IntegerExhaustive, UnsignedSigned) { check_left<false, true, 1, 2, 3, 4, 5, 6>(); }
TEST(IntegerExhaustive, SignedUnsigned) { check_left<true, false, 1, 2, 3, 4, 5, 6>(); }
TEST(IntegerExhaustive, SignedSigned) { check_left<true, true, 1, 2, 3, 4, 5, 6>(); }

}  // namespace
