/// ap_fixed<W, I, Q, O, N> and ap_ufixed: W bits of which I stand left of the point (I may be negative or
/// exceed W), with the quantisation Q and overflow O of Vitis HLS whenever a value is converted to the type.
#ifndef AP_FIXED_H
#define AP_FIXED_H

#include "ap_int.h"
#include "detail/conversion.h"

/// What ap_fixed and ap_ufixed share. S: two's complement.
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
struct ap_fixed_base : ap_detail::Bits<W, S> {
  static_assert(S || O != AP_WRAP_SM, "AP_WRAP_SM needs a signed type");
  typedef ap_detail::Bits<W, S> Base;
  using Base::Base;
  using Base::V;
  static const int iwidth = I;
  static const ap_q_mode qmode = Q;
  static const ap_o_mode omode = O;

  ap_fixed_base() = default;
  template <class T, class = ap_detail::IfOperand<T>>
  AP_EXPRESSION ap_fixed_base(const T& x)
      : Base(ap_detail::FromBits(), Conversion::template from<ap_detail::ShapeOf<T>::F>(ap_detail::raw(x))) {}
  AP_EXPRESSION ap_fixed_base(double x)
      : Base(ap_detail::FromBits(), Conversion::template from<W - I + 2>(ap_detail::scaled<W + 60>(
                                        ap_detail::significand(x), ap_detail::exponent(x) + W - I + 2))) {}
  AP_EXPRESSION ap_fixed_base(float x) : ap_fixed_base(double(x)) {}

#ifndef __SYNTHESIS__
  /// As std::strtod reads it: "-1.25", "0x1.8", up to 53 significant bits.
  ap_fixed_base(const char* text) : ap_fixed_base(std::strtod(text, nullptr)) {}
  /// Radix 2, 8, 10 or 16; every digit of the exact number.
  std::string to_string(int radix = 2) const {
    return (this->is_neg() ? "-" : "") + std::string(ap_detail::radix_prefix(radix)) +
           ap_detail::fixed_digits<W + 1, W - I>(this->is_neg()
                                                     ? -static_cast<ap_detail::Unsigned<W + 1>>(this->raw())
                                                     : static_cast<ap_detail::Unsigned<W + 1>>(this->raw()),
                                                 radix);
  }
#endif

  template <class T, class = typename std::enable_if<std::is_arithmetic<T>::value>::type>
  AP_EXPRESSION operator T() const {
    return to_native<T>(std::is_floating_point<T>());
  }
  AP_EXPRESSION operator bool() const { return V != 0; }

  AP_EXPRESSION ap_int<ap_detail::larger(I, 1)> to_ap_int_base() const {
    return ap_int<ap_detail::larger(I, 1)>(*this);
  }
  AP_EXPRESSION int to_int() const { return static_cast<int>(ap_detail::integer(*this)); }
  AP_EXPRESSION unsigned to_uint() const { return static_cast<unsigned>(ap_detail::integer(*this)); }
  AP_EXPRESSION long to_long() const { return static_cast<long>(ap_detail::integer(*this)); }
  AP_EXPRESSION long long to_int64() const { return static_cast<long long>(ap_detail::integer(*this)); }
  AP_EXPRESSION unsigned long long to_uint64() const {
    return static_cast<unsigned long long>(ap_detail::integer(*this));
  }
  /// Exact up to 53 significant bits, to nearest beyond.
  AP_EXPRESSION double to_double() const {
    return static_cast<double>(this->raw()) * ap_detail::power_of_two(I - W);
  }
  AP_EXPRESSION float to_float() const {
    return static_cast<float>(this->raw()) * static_cast<float>(ap_detail::power_of_two(I - W));
  }

  /// Bits counted from the point: 0 is the lowest integer bit, -1 the highest fraction bit.
  AP_EXPRESSION bool get_bit(int i) const { return this->bit(i + W - I); }
  AP_INLINE void set_bit(int i, bool on) { this->bit(i + W - I) = on; }

  AP_EXPRESSION ap_fixed_base operator+() const { return *this; }
  AP_EXPRESSION ap_fixed<W + 1, I + 1> operator-() const {
    return ap_fixed<W + 1, I + 1>(ap_detail::FromBits(),
                                  -static_cast<ap_detail::Unsigned<W + 1>>(this->raw()));
  }
  AP_EXPRESSION ap_fixed_base<W, I, S, AP_TRN, AP_WRAP, 0> operator~() const {
    return ap_fixed_base<W, I, S, AP_TRN, AP_WRAP, 0>(ap_detail::FromBits(), ~V);
  }

 private:
  typedef ap_detail::Conversion<W, I, S, Q, O, N> Conversion;
  template <class T>
  AP_EXPRESSION T to_native(std::true_type) const {
    return static_cast<T>(to_double());
  }
  template <class T>
  AP_EXPRESSION T to_native(std::false_type) const {
    return static_cast<T>(ap_detail::integer(*this));
  }
};

template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
struct ap_fixed : ap_fixed_base<W, I, true, Q, O, N> {
  using ap_fixed_base<W, I, true, Q, O, N>::ap_fixed_base;
  ap_fixed() = default;
};

template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
struct ap_ufixed : ap_fixed_base<W, I, false, Q, O, N> {
  using ap_fixed_base<W, I, false, Q, O, N>::ap_fixed_base;
  ap_ufixed() = default;
};

#ifndef __SYNTHESIS__
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
std::ostream& operator<<(std::ostream& out, const ap_fixed_base<W, I, S, Q, O, N>& x) {
  return out << x.to_string(ap_detail::stream_radix(out));
}
#endif

#endif
