/// ap_int<W> and ap_uint<W>: integers of W bits that wrap, with the names and result widths of Vitis HLS.
#ifndef AP_INT_H
#define AP_INT_H

#include "detail/operators.h"
#include "detail/real.h"
#ifdef __SYNTHESIS__
#include "detail/literal.h"
#else
#include "detail/text.h"
#endif

/// What ap_int and ap_uint share. S: two's complement.
template <int W, bool S>
struct ap_int_base : ap_detail::Bits<W, S> {
  typedef ap_detail::Bits<W, S> Base;
  using Base::Base;
  using Base::V;
  typedef typename std::conditional<S, long long, unsigned long long>::type Native;

  ap_int_base() = default;
  /// Any integer, wrapped to W bits; a fixed-point number is cut towards zero first.
  template <class T, class = ap_detail::IfOperand<T>>
  AP_EXPRESSION ap_int_base(const T& x) : Base(ap_detail::FromBits(), ap_detail::integer(x)) {}
  AP_EXPRESSION ap_int_base(double x) : Base(ap_detail::FromBits(), ap_detail::real_to_integer<W>(x)) {}
  AP_EXPRESSION ap_int_base(float x) : ap_int_base(double(x)) {}
#ifdef __SYNTHESIS__
  template <int N>
  ap_int_base(const char (&text)[N], int radix = 0)
      : Base(ap_detail::FromBits(), ap_detail::literal_integer<W>(text, radix)) {}
#else
  /// "-12", "0x1f", "0b101", "0o17"; digits of `radix` when it is given.
  ap_int_base(const char* text, int radix = 0)
      : Base(ap_detail::FromBits(), ap_detail::parse_integer<W>(text, radix)) {}
  std::string to_string(int radix = 2, bool as_signed = S) const {
    return ap_detail::integer_text<W>(V, as_signed, radix);
  }
#endif

  AP_EXPRESSION operator Native() const { return static_cast<Native>(this->raw()); }

  AP_EXPRESSION bool to_bool() const { return V != 0; }
  AP_EXPRESSION char to_char() const { return static_cast<char>(this->raw()); }
  AP_EXPRESSION int to_int() const { return static_cast<int>(this->raw()); }
  AP_EXPRESSION unsigned to_uint() const { return static_cast<unsigned>(this->raw()); }
  AP_EXPRESSION long to_long() const { return static_cast<long>(this->raw()); }
  AP_EXPRESSION unsigned long to_ulong() const { return static_cast<unsigned long>(this->raw()); }
  AP_EXPRESSION long long to_int64() const { return static_cast<long long>(this->raw()); }
  AP_EXPRESSION unsigned long long to_uint64() const { return static_cast<unsigned long long>(this->raw()); }
  AP_EXPRESSION double to_double() const { return static_cast<double>(this->raw()); }
  AP_EXPRESSION float to_float() const { return static_cast<float>(this->raw()); }

  AP_EXPRESSION bool sign() const { return this->is_neg(); }
  AP_EXPRESSION bool get_bit(int i) const { return this->bit(i); }
  AP_EXPRESSION bool test(int i) const { return this->bit(i); }
  AP_INLINE void set_bit(int i, bool on) { this->bit(i) = on; }
  AP_INLINE void set(int i, bool on = true) { this->bit(i) = on; }
  AP_INLINE void set() { V = ap_detail::ones<W>(W); }
  AP_INLINE void clear(int i) { this->bit(i) = false; }
  AP_INLINE void clear() { V = 0; }
  AP_INLINE void invert(int i) { this->bit(i) = !this->bit(i); }
  AP_INLINE void b_not() { V = ~V; }

  AP_INLINE ap_int_base& reverse() {
    V = ap_detail::Halves<W>::reverse(V);
    return *this;
  }
  /// Rotates by n places, 0 <= n < W.
  AP_INLINE void lrotate(int n) {
    V = ap_detail::shift_left<W, false>(V, ap_detail::checked("lrotate", n, W)) |
        ap_detail::shift_right<W, false>(V, W - n);
  }
  AP_INLINE void rrotate(int n) {
    V = ap_detail::shift_right<W, false>(V, ap_detail::checked("rrotate", n, W)) |
        ap_detail::shift_left<W, false>(V, W - n);
  }
  AP_EXPRESSION int countLeadingZeros() const { return __builtin_clzg(V, W); }

  AP_EXPRESSION ap_int_base operator+() const { return *this; }
  AP_EXPRESSION ap_int<ap_detail::larger(W, 1 + S) + 1> operator-() const {
    typedef ap_int<ap_detail::larger(W, 1 + S) + 1> R;
    return R(ap_detail::FromBits(), -static_cast<ap_detail::Unsigned<R::width>>(this->raw()));
  }
  AP_EXPRESSION ap_int<W + !S> operator~() const {
    return ap_int<W + !S>(ap_detail::FromBits(), ~static_cast<ap_detail::Unsigned<W + !S>>(this->raw()));
  }

  template <class T>
  AP_INLINE auto concat(T&& low) -> decltype((*this, std::forward<T>(low))) {
    return (*this, std::forward<T>(low));
  }
  template <class T>
  AP_INLINE auto concat(T&& low) const -> decltype((*this, std::forward<T>(low))) {
    return (*this, std::forward<T>(low));
  }
};

namespace ap_detail {
template <class T>
using IfVolatile = typename std::enable_if<std::is_volatile<T>::value>::type;

/// What a volatile number holds.
template <class T>
AP_INLINE Plain<T> now(T& x) {
  return Plain<T>(FromBits(), x.V);
}

/// What a volatile number is set to; a type of its own, so that setting it is no copy assignment.
template <int W, bool S>
struct Assigned {
  template <class T, class = IfOperand<T>>
  AP_INLINE Assigned(const T& x) : value(x) {}
  template <class T, class = IfVolatile<T>, class = void>
  AP_INLINE Assigned(T& x) : value(now(x)) {}
  ap_int_base<W, S> value;
};
}  // namespace ap_detail

template <int W>
struct ap_int : ap_int_base<W, true> {
  using ap_int_base<W, true>::ap_int_base;
  ap_int() = default;
  template <class T, class = ap_detail::IfVolatile<T>, class = void>
  AP_INLINE ap_int(T& x) : ap_int(ap_detail::now(x)) {}
  template <class T, class = ap_detail::IfVolatile<T>>
  AP_INLINE ap_int& operator=(T& x) {
    return *this = ap_int(x);
  }
  AP_INLINE void operator=(ap_detail::Assigned<W, true> x) volatile { this->V = x.value.V; }
};

template <int W>
struct ap_uint : ap_int_base<W, false> {
  using ap_int_base<W, false>::ap_int_base;
  ap_uint() = default;
  template <class T, class = ap_detail::IfVolatile<T>, class = void>
  AP_INLINE ap_uint(T& x) : ap_uint(ap_detail::now(x)) {}
  template <class T, class = ap_detail::IfVolatile<T>>
  AP_INLINE ap_uint& operator=(T& x) {
    return *this = ap_uint(x);
  }
  AP_INLINE void operator=(ap_detail::Assigned<W, false> x) volatile { this->V = x.value.V; }
};

#ifndef __SYNTHESIS__
template <int W, bool S>
std::ostream& operator<<(std::ostream& out, const ap_int_base<W, S>& x) {
  return out << x.to_string(ap_detail::stream_radix(out));
}
template <class D, int W>
std::ostream& operator<<(std::ostream& out, const ap_detail::Reference<D, W>& part) {
  return out << part.get();
}
template <int W, bool S>
std::istream& operator>>(std::istream& in, ap_int_base<W, S>& x) {
  std::string text;
  in >> text;
  x = ap_int_base<W, S>(text.c_str(), ap_detail::stream_radix(in));
  return in;
}
#endif

#endif
