/// Numbers as text, for C simulation: printing and parsing in any radix from 2 to 36.
#ifndef AP_DETAIL_TEXT_H
#define AP_DETAIL_TEXT_H

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

#include "literal.h"
#include "operands.h"

namespace ap_detail {

inline const char* radix_prefix(int radix) {
  return radix == 2 ? "0b" : radix == 8 ? "0o" : radix == 16 ? "0x" : "";
}

inline char digit(int value) { return "0123456789abcdefghijklmnopqrstuvwxyz"[value]; }

/// Digits of `bits`, most significant first.
template <int W>
std::string digits(Unsigned<W> bits, int radix) {
  typedef Unsigned<larger(W, 7)> Wide;
  std::string text;
  Wide rest = bits;
  do {
    text += digit(static_cast<int>(rest % static_cast<Wide>(radix)));
    rest /= static_cast<Wide>(radix);
  } while (rest != 0);
  std::reverse(text.begin(), text.end());
  return text;
}

/// Vitis style: prefix for radix 2, 8 and 16, minus sign in front of all.
template <int W>
std::string integer_text(Unsigned<W> bits, bool as_signed, int radix) {
  const bool negative = as_signed && (bits >> (W - 1)) != 0;
  return (negative ? "-" : "") + std::string(radix_prefix(radix)) +
         digits<W>(negative ? static_cast<Unsigned<W>>(-bits) : bits, radix);
}

template <int W>
Unsigned<W> parse_integer(const char* text, int radix) {
  const std::string whole = text;
  const bool negative = *text == '-';
  if (*text == '-' || *text == '+') ++text;
  const int prefix = prefix_radix(text);
  if (prefix != 10) text += 2;
  if (radix == 0) radix = prefix;
  typedef Unsigned<larger(W, 7)> Wide;
  Wide value = 0;
  for (; *text; ++text) {
    if (digit_value(*text) >= radix) {
      throw std::invalid_argument("\"" + whole + "\" is no number of radix " + std::to_string(radix) +
                                  "; write digits, with 0x, 0b or 0o in front for another radix");
    }
    value = value * static_cast<Wide>(radix) + static_cast<Wide>(digit_value(*text));
  }
  return static_cast<Unsigned<W>>(negative ? -value : value);
}

/// All digits of magnitude * 2^-F, exactly; radix 2, 8, 10 or 16, in which every binary fraction ends.
template <int W, int F>
std::string fixed_digits(Unsigned<W> magnitude, int radix) {
  static const int point = larger(F, 0);
  typedef Unsigned<larger(W, point) + larger(-F, 0) + 5> Wide;
  Wide rest = static_cast<Wide>(magnitude) << larger(-F, 0);
  std::string text = digits<larger(W, point) + larger(-F, 0) + 5>(rest >> point, radix);
  rest &= (Wide(1) << point) - 1;
  if (rest != 0) text += '.';
  while (rest != 0) {
    rest *= static_cast<Wide>(radix);
    text += digit(static_cast<int>(rest >> point));
    rest &= (Wide(1) << point) - 1;
  }
  return text;
}

inline int stream_radix(const std::ios_base& stream) {
  const std::ios_base::fmtflags base = stream.flags() & std::ios_base::basefield;
  return base == std::ios_base::hex ? 16 : base == std::ios_base::oct ? 8 : 10;
}

}  // namespace ap_detail

#endif
