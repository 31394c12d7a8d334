/// hls_math.h for integers and fixed-point numbers: hls::abs, min, max, sqrt, floor, ceil, round, trunc,
/// signbit. Test benches also find the functions of <cmath> for float and double in hls; hardware has no
/// floating point.
#ifndef HLS_MATH_H
#define HLS_MATH_H

#include <cmath>

#include "ap_fixed.h"

namespace hls {

namespace detail {

/// The greatest whole number whose square is not above `x`, a bit at a time.
template <int W>
AP_INLINE ap_uint<(W + 1) / 2> whole_root(ap_uint<W> x) {
  const int kBits = (W + 1) / 2;
  ap_uint<kBits> root = 0;
  ap_uint<kBits + 2> rest = 0;
ROOT:
  for (int i = kBits - 1; i >= 0; --i) {
    const ap_uint<1> high = 2 * i + 1 < W && x.get_bit(2 * i + 1 < W ? 2 * i + 1 : 0);
    const ap_uint<1> low = x.get_bit(2 * i);
    const ap_uint<kBits + 4> next = (ap_uint<kBits + 4>(rest) << 2) | (ap_uint<2>(high) << 1) | low;
    const ap_uint<kBits + 4> trial = (ap_uint<kBits + 4>(root) << 2) | 1;
    const bool fits = next >= trial;
    rest = fits ? ap_uint<kBits + 4>(next - trial) : next;
    root = (ap_uint<kBits + 1>(root) << 1) | ap_uint<1>(fits);
  }
  return root;
}

/// The root of a fixed-point number in its own format, cut; 0 for what is below zero.
template <class Fixed, int W, int I>
AP_INLINE Fixed fixed_root(const Fixed& x) {
  static_assert(W >= I, "hls::sqrt needs a format whose point is in or right of the word");
  const int kFraction = W - I;
  ap_uint<W + kFraction> bits = 0;
  if (!x.is_neg()) bits.range(W + kFraction - 1, kFraction) = x.range();
  Fixed root = 0;
  root.range() = ap_uint<W>(whole_root<W + kFraction>(bits));
  return root;
}

template <class T>
using IfInteger = typename std::enable_if<std::is_integral<T>::value>::type;

}  // namespace detail

using std::acos;
using std::asin;
using std::atan;
using std::atan2;
using std::cos;
using std::exp;
using std::fabs;
using std::fmax;
using std::fmin;
using std::log;
using std::pow;
using std::sin;
using std::tan;

template <class T>
AP_INLINE T max(const T& a, const T& b) {
  return a > b ? a : b;
}
template <class T>
AP_INLINE T min(const T& a, const T& b) {
  return a < b ? a : b;
}

AP_INLINE float abs(float x) { return std::fabs(x); }
AP_INLINE double abs(double x) { return std::fabs(x); }
/// In the operand's own type: the least signed value stays what it is.
template <class T, class = detail::IfInteger<T>>
AP_INLINE T abs(T x) {
  return x < 0 ? T(-x) : x;
}
template <int W>
AP_INLINE ap_int<W> abs(const ap_int<W>& x) {
  return x < 0 ? ap_int<W>(-x) : x;
}
template <int W>
AP_INLINE ap_uint<W> abs(const ap_uint<W>& x) {
  return x;
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> abs(const ap_fixed<W, I, Q, O, N>& x) {
  return x < 0 ? ap_fixed<W, I, Q, O, N>(-x) : x;
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_ufixed<W, I, Q, O, N> abs(const ap_ufixed<W, I, Q, O, N>& x) {
  return x;
}

AP_INLINE float sqrt(float x) { return std::sqrt(x); }
AP_INLINE double sqrt(double x) { return std::sqrt(x); }
/// Cut to a whole number.
template <class T, class = detail::IfInteger<T>>
AP_INLINE T sqrt(T x) {
  return x < 0 ? 0 : static_cast<T>(detail::whole_root<8 * sizeof(T)>(ap_uint<8 * sizeof(T)>(x)));
}
template <int W>
AP_INLINE ap_uint<(W + 1) / 2> sqrt(const ap_uint<W>& x) {
  return detail::whole_root<W>(x);
}
template <int W>
AP_INLINE ap_int<W> sqrt(const ap_int<W>& x) {
  return x < 0 ? ap_int<W>(0) : ap_int<W>(detail::whole_root<W>(ap_uint<W>(x)));
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> sqrt(const ap_fixed<W, I, Q, O, N>& x) {
  return detail::fixed_root<ap_fixed<W, I, Q, O, N>, W, I>(x);
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_ufixed<W, I, Q, O, N> sqrt(const ap_ufixed<W, I, Q, O, N>& x) {
  return detail::fixed_root<ap_ufixed<W, I, Q, O, N>, W, I>(x);
}

/// To the whole number below, above, nearest (halves away from zero), or towards zero.
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> floor(const ap_fixed<W, I, Q, O, N>& x) {
  return ap_fixed<I, I, AP_TRN>(x);
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> ceil(const ap_fixed<W, I, Q, O, N>& x) {
  return -ap_fixed<I + 1, I + 1, AP_TRN>(-x);
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> round(const ap_fixed<W, I, Q, O, N>& x) {
  return ap_fixed<I + 1, I + 1, AP_RND_INF>(x);
}
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE ap_fixed<W, I, Q, O, N> trunc(const ap_fixed<W, I, Q, O, N>& x) {
  return ap_fixed<I, I, AP_TRN_ZERO>(x);
}

template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
AP_INLINE bool signbit(const ap_fixed<W, I, Q, O, N>& x) {
  return x.is_neg();
}

}  // namespace hls

#endif
