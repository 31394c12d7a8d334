/// Exhaustive checks of one fixed-point type against SystemC: every bit pattern of every source given. A case
/// is a pair of types; the loops over cases run on function pointers, so that a case costs the compiler one
/// small function.
#ifndef FLOORLINE_TB_TYPES_FIXED_CASES_H
#define FLOORLINE_TB_TYPES_FIXED_CASES_H

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ap_fixed.h"
#include "reference.h"

namespace fixed_cases {

template <int W, int I, bool S, ap_q_mode Q = AP_TRN, ap_o_mode O = AP_WRAP, int N = 0>
using Fixed = typename std::conditional<S, ap_fixed<W, I, Q, O, N>,
                                        ap_ufixed<W, I, Q, O == AP_WRAP_SM ? AP_WRAP : O, N>>::type;

/// Reads `bits` as a Source, converts it, and returns the number in units of the target's last bit.
using Convert = int (*)(int bits);
template <class Target, class Source>
int convert(int bits) {
  return static_cast<int>(Target(Source(ap_detail::FromBits(), bits)).raw());
}
using ConvertReal = int (*)(double);
template <class Target>
int convert_real(double value) {
  return static_cast<int>(Target(value).raw());
}

/// A source format with `dropped` more fraction bits than the target.
struct Source {
  int width;
  bool is_signed;
  int dropped;
  Convert convert;
};

inline double value_of(int bits, int width, bool is_signed, int fraction) {
  const int number = is_signed && bits >> (width - 1) ? bits - (1 << width) : bits;
  return std::ldexp(number, -fraction);
}

inline void check(reference::Format format, reference::Modes modes, const std::vector<Source>& sources,
                  ConvertReal real) {
  reference::Fixed expected(format, modes);
  for (const Source& source : sources) {
    const int fraction = format.width - format.integer + source.dropped;
    for (int bits = 0; bits < 1 << source.width; ++bits) {
      const double value = value_of(bits, source.width, source.is_signed, fraction);
      const long long number = expected.assign(value);
      ASSERT_EQ(source.convert(bits), number)
          << "from " << value << " of " << source.width << " bits, " << fraction << " of fraction, to width "
          << format.width << " signed " << format.is_signed << " Q " << modes.q << " O " << modes.o << " N "
          << modes.n;
      ASSERT_EQ(real(value), number) << "from the double " << value;
    }
  }
}

/// A target type and its sources. I may be anything: what counts is where the source's last bit lies.
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N = 0>
struct Target {
  using Type = Fixed<W, I, S, Q, O, N>;

  /// W2 bits of which the last is D places below the target's.
  template <int W2, bool S2, int D>
  static Source from() {
    return {W2, S2, D, convert<Type, Fixed<W2, W2 - (W - I) - D, S2>>};
  }
  static void check_sources(const std::vector<Source>& sources) {
    check({W, I, S}, {Q, O, N}, sources, convert_real<Type>);
  }
};

}  // namespace fixed_cases

#endif
