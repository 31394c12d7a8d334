/// Exact conversion of double to words; constant-evaluable, so that tables of constants need no start-up
/// code.
#ifndef AP_DETAIL_REAL_H
#define AP_DETAIL_REAL_H

#include "operands.h"

namespace ap_detail {

/// IEEE 754 binary64: value = significand * 2^exponent. Not-a-number reads as 0, infinity as its huge power
/// of two.
AP_EXPRESSION unsigned long long ieee_bits(double x) { return __builtin_bit_cast(unsigned long long, x); }
AP_EXPRESSION int ieee_field(double x) { return static_cast<int>(ieee_bits(x) >> 52 & 0x7ff); }
AP_EXPRESSION int exponent(double x) { return larger(ieee_field(x), 1) - 1075; }
AP_EXPRESSION _BitInt(54) significand(double x) {
  return x != x ? 0
                : static_cast<_BitInt(54)>((ieee_bits(x) & 0xfffffffffffffULL) |
                                           (ieee_field(x) != 0 ? 0x10000000000000ULL : 0)) *
                      (x < 0 ? -1 : 1);
}

/// floor(x * 2^shift), its last bit also set when anything was cut off, so that it still rounds as x does
/// when two more bits are dropped. W - 56 bits are exact: a longer left shift is cut short, which leaves
/// these bits 0 and the value beyond them on its side.
template <int W>
AP_EXPRESSION _BitInt(W) scaled(_BitInt(54) x, int shift) {
  return shift >= 0
             ? static_cast<_BitInt(W)>(static_cast<Unsigned<W>>(x) << smaller(shift, W - 56))
             : static_cast<_BitInt(W)>(x >> smaller(-shift, 53)) | ((x & ones<53>(smaller(-shift, 53))) != 0);
}

/// 2^n, |n| <= 1022.
AP_EXPRESSION double power_of_two(int n) {
  return __builtin_bit_cast(double, static_cast<unsigned long long>(n + 1023) << 52);
}

/// x cut towards zero, modulo 2^W.
template <int W>
AP_EXPRESSION Unsigned<W> real_to_integer(double x) {
  return static_cast<Unsigned<W>>(
      exponent(x) >= 0 ? static_cast<Unsigned<W + 56>>(significand(x)) << smaller(exponent(x), W)
                       : static_cast<Unsigned<W + 56>>(
                             significand(x) / (static_cast<_BitInt(56)>(1) << smaller(-exponent(x), 54))));
}

}  // namespace ap_detail

#endif
