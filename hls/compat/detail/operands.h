/// How an operand of any kind shows itself to the operators: its shape (width, point, sign) and its raw
/// number.
#ifndef AP_DETAIL_OPERANDS_H
#define AP_DETAIL_OPERANDS_H

#include "raw.h"

namespace ap_detail {

/// W bits of which I stand left of the point, so W - I are the fraction; integers have I = W.
template <int W_, int I_, bool S_, bool IsFixed_>
struct Shape {
  static const int W = W_, I = I_, F = W_ - I_;
  static const bool S = S_, is_fixed = IsFixed_;
};
template <int W, bool S>
using IntegerShape = Shape<W, W, S, false>;

template <class T>
struct IsNative {
  static const bool value =
      std::is_integral<T>::value || (std::is_enum<T>::value && std::is_convertible<T, long long>::value);
};
template <class T>
struct NativeWidth {
  static const int value = std::is_same<T, bool>::value ? 1 : 8 * int(sizeof(T));
};
template <class T, bool IsEnum = std::is_enum<T>::value>
struct IsSigned : std::is_signed<T> {};
template <class T>
struct IsSigned<T, true> : std::is_signed<typename std::underlying_type<T>::type> {};

template <int W, bool S>
IntegerShape<W, S> shape_of(const ap_int_base<W, S>&);
template <class D, int W>
IntegerShape<W, false> shape_of(const Reference<D, W>&);
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
Shape<W, I, S, true> shape_of(const ap_fixed_base<W, I, S, Q, O, N>&);
template <class T, class = typename std::enable_if<IsNative<T>::value>::type>
IntegerShape<NativeWidth<T>::value, IsSigned<T>::value> shape_of(const T&);

template <class T>
using ShapeOf = decltype(shape_of(std::declval<const T&>()));

template <class T, class Enable = void>
struct IsOperand : std::false_type {};
template <class T>
struct IsOperand<T, typename std::enable_if<(ShapeOf<T>::W > 0)>::type> : std::true_type {};

template <class T>
using IfOperand = typename std::enable_if<IsOperand<T>::value>::type;
template <class T>
using IfNotFixed = typename std::enable_if<!ShapeOf<T>::is_fixed>::type;
template <class T>
using IfFixed = typename std::enable_if<ShapeOf<T>::is_fixed>::type;

/// Two operands of which at least one is ours: the operators below take no part in purely native expressions.
template <class A, class B>
using IfOperands = typename std::enable_if<IsOperand<A>::value && IsOperand<B>::value &&
                                           !(IsNative<A>::value && IsNative<B>::value)>::type;

template <class T>
using Plain = typename std::remove_cv<typename std::remove_reference<T>::type>::type;

/// Values of our own types, which ++ and += change; parts of a word are not among them.
template <int W, bool S>
std::true_type is_word(const Bits<W, S>&);
template <class T>
using IfWord = typename std::enable_if<decltype(is_word(std::declval<const T&>()))::value>::type;

template <class T, class = typename std::enable_if<IsNative<T>::value>::type>
AP_EXPRESSION Raw<ShapeOf<T>::W, ShapeOf<T>::S> raw(const T& x) {
  return static_cast<Raw<ShapeOf<T>::W, ShapeOf<T>::S>>(x);
}
template <class T, class = typename std::enable_if<!IsNative<T>::value>::type, class = IfOperand<T>>
AP_EXPRESSION Raw<ShapeOf<T>::W, ShapeOf<T>::S> raw(const T& x) {
  return x.raw();
}

/// x as the bits of a word of W bits with F fraction bits, no less than x has; wraps when W is too narrow.
template <int W, int F, class T>
AP_EXPRESSION Unsigned<W> aligned(const T& x) {
  return static_cast<Unsigned<W>>(raw(x)) << (F - ShapeOf<T>::F);
}

/// The number without its fraction, cut towards zero as C does.
template <int Fraction, bool S, class T>
AP_EXPRESSION typename std::enable_if<(Fraction <= 0), T>::type cut(T x) {
  return x;
}
template <int Fraction, bool S, class T>
AP_EXPRESSION typename std::enable_if<(Fraction > 0), T>::type cut(T x) {
  return (x >> Fraction) + T(S && x < 0 && (x & ((T(1) << Fraction) - 1)) != 0);
}
template <class T>
struct Integer {
  typedef ShapeOf<T> s;
  static const int W = larger(s::W, s::F + 2) + larger(-s::F, 0);
  typedef Raw<W, s::S> type;
};
template <class T>
AP_EXPRESSION typename Integer<T>::type integer(const T& x) {
  typedef ShapeOf<T> s;
  typedef Integer<T> I;
  return cut<s::F, s::S>(
      static_cast<typename I::type>(static_cast<Unsigned<I::W>>(raw(x)) << larger(-s::F, 0)));
}

/// The type that holds a result: ap_int, ap_uint, or (ap_fixed.h) ap_fixed and ap_ufixed.
template <int W, int I, bool S, bool IsFixed>
struct Value;
template <int W, int I>
struct Value<W, I, true, false> {
  typedef ap_int<W> type;
};
template <int W, int I>
struct Value<W, I, false, false> {
  typedef ap_uint<W> type;
};

/// Result types of A op B as published for Vitis HLS; integers and fixed-point share the rules except for /
/// and %.
template <class A, class B>
struct Results {
  typedef ShapeOf<A> a;
  typedef ShapeOf<B> b;
  static const bool S = a::S || b::S;
  static const bool is_fixed = a::is_fixed || b::is_fixed;
  static const int F = larger(a::F, b::F);
  static const int I = larger(a::I + (b::S && !a::S), b::I + (a::S && !b::S));
  static const int quotient_shift = larger(b::F, 0);

  typedef typename Value<I + 1 + F, I + 1, S, is_fixed>::type plus;
  typedef typename Value<I + 1 + F, I + 1, true, is_fixed>::type minus;
  typedef typename Value<I + F, I, S, is_fixed>::type logic;
  typedef typename Value<a::W + b::W, a::I + b::I, S, is_fixed>::type mult;
  typedef typename Value<a::W + quotient_shift + b::S, a::I + b::F + b::S, S, is_fixed>::type div;
  static const int mod_w = smaller(a::W, b::W + (a::S && !b::S));
  typedef typename Value<mod_w, mod_w, a::S, is_fixed>::type mod;
};

}  // namespace ap_detail

#endif
