/// Numbers as string literals: "-12", "0x1f", "0b101", "0o17"; digits of a radix when it is given.
#ifndef AP_DETAIL_LITERAL_H
#define AP_DETAIL_LITERAL_H

#include "raw.h"

namespace ap_detail {

AP_INLINE int digit_value(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'z' ? c - 'a' + 10
         : c >= 'A' && c <= 'Z' ? c - 'A' + 10
                                : 36;
}

/// The radix that a prefix names; 10 without one.
AP_INLINE int prefix_radix(const char* text) {
  if (text[0] != '0') return 10;
  const char letter = text[1] | 32;
  return letter == 'x' ? 16 : letter == 'b' ? 2 : letter == 'o' ? 8 : 10;
}

/// The value of a literal, in hardware a constant. C simulation, which can complain, has parse_integer.
template <int W, int N>
AP_INLINE Unsigned<W> literal_integer(const char (&text)[N], int radix) {
  const int sign = text[0] == '-' || text[0] == '+' ? 1 : 0;
  const int prefix = prefix_radix(text + sign);
  const int first = sign + (prefix == 10 ? 0 : 2);
  if (radix == 0) radix = prefix;
  typedef Unsigned<larger(W, 7)> Wide;
  Wide value = 0;
  for (int i = 0; i < N - 1; ++i)
    if (i >= first) value = value * static_cast<Wide>(radix) + static_cast<Wide>(digit_value(text[i]));
  return static_cast<Unsigned<W>>(text[0] == '-' ? -value : value);
}

}  // namespace ap_detail

#endif
