/// The operators of all arbitrary-precision types, found by argument-dependent lookup.
/// Results are as wide as the published Vitis HLS rules say, so that + - * never lose a bit. Arithmetic runs
/// on unsigned words of the result's width: the same bits, and no undefined overflow.
#ifndef AP_DETAIL_OPERATORS_H
#define AP_DETAIL_OPERATORS_H

#include "bits.h"

namespace ap_detail {

#define AP_ALIGNED_OPERATOR(symbol, result)                                                         \
  template <class A, class B, class = IfOperands<A, B>>                                             \
  AP_EXPRESSION typename Results<A, B>::result operator symbol(const A& a, const B& b) {            \
    typedef typename Results<A, B>::result R;                                                       \
    return R(FromBits(),                                                                            \
             aligned<R::width, Results<A, B>::F>(a) symbol aligned<R::width, Results<A, B>::F>(b)); \
  }
AP_ALIGNED_OPERATOR(+, plus)
AP_ALIGNED_OPERATOR(-, minus)
AP_ALIGNED_OPERATOR(&, logic)
AP_ALIGNED_OPERATOR(|, logic)
AP_ALIGNED_OPERATOR(^, logic)
#undef AP_ALIGNED_OPERATOR

template <class A, class B, class = IfOperands<A, B>>
AP_EXPRESSION typename Results<A, B>::mult operator*(const A& a, const B& b) {
  typedef typename Results<A, B>::mult R;
  return R(FromBits(), static_cast<Unsigned<R::width>>(raw(a)) * static_cast<Unsigned<R::width>>(raw(b)));
}

/// A word wide enough for both operands of a division as they are, signed when one of them is.
template <class A, class B, int Shift>
struct Division {
  typedef Results<A, B> R;
  static const int W =
      larger(R::a::W + Shift + (R::b::S && !R::a::S), R::b::W + (R::a::S && !R::b::S)) + R::S;
  typedef Raw<W, R::S> type;
};

/// Quotient, cut towards zero. A zero divisor stops C simulation with the processor's division trap.
template <class A, class B, class = IfOperands<A, B>>
AP_EXPRESSION typename Results<A, B>::div operator/(const A& a, const B& b) {
  typedef Results<A, B> R;
  typedef Division<A, B, R::quotient_shift> D;
  return typename R::div(
      FromBits(), static_cast<typename D::type>(static_cast<Unsigned<D::W>>(raw(a)) << R::quotient_shift) /
                      static_cast<typename D::type>(raw(b)));
}

/// Remainder of integers with the sign of the dividend.
template <class A, class B, class = IfOperands<A, B>, class = IfNotFixed<A>, class = IfNotFixed<B>>
AP_EXPRESSION typename Results<A, B>::mod operator%(const A& a, const B& b) {
  typedef typename Division<A, B, 0>::type D;
  return typename Results<A, B>::mod(FromBits(), static_cast<D>(raw(a)) % static_cast<D>(raw(b)));
}

/// Exact comparison whatever the widths, points and signs; with floating point, as double.
template <class A, class B>
struct Common {
  typedef Results<A, B> R;
  static const int W = larger(R::I + R::F, 1 + R::S);
  static AP_EXPRESSION Raw<W, R::S> left(const A& a) {
    return static_cast<Raw<W, R::S>>(aligned<W, R::F>(a));
  }
  static AP_EXPRESSION Raw<W, R::S> right(const B& b) {
    return static_cast<Raw<W, R::S>>(aligned<W, R::F>(b));
  }
};
#define AP_COMPARISON(symbol)                                   \
  template <class A, class B, class = IfOperands<A, B>>         \
  AP_EXPRESSION bool operator symbol(const A& a, const B& b) {  \
    return Common<A, B>::left(a) symbol Common<A, B>::right(b); \
  }                                                             \
  template <class A, class = IfFixed<A>>                        \
  AP_EXPRESSION bool operator symbol(const A& a, double b) {    \
    return a.to_double() symbol b;                              \
  }                                                             \
  template <class B, class = IfFixed<B>>                        \
  AP_EXPRESSION bool operator symbol(double a, const B& b) {    \
    return a symbol b.to_double();                              \
  }
AP_COMPARISON(==)
AP_COMPARISON(!=)
AP_COMPARISON(<)
AP_COMPARISON(<=)
AP_COMPARISON(>)
AP_COMPARISON(>=)
#undef AP_COMPARISON

/// The type of a shift is that of its left operand; fixed-point keeps its modes (conversion.h).
template <class T, class = IfNotFixed<T>>
typename Value<ShapeOf<T>::W, ShapeOf<T>::I, ShapeOf<T>::S, false>::type shifted_type(const T&);

/// x shifted left by n >= 0 bits within its width; all bits go when n reaches the width.
template <int W, bool S, class T, class N>
AP_EXPRESSION Raw<W, S> shift_left(T x, N n) {
  return n >= static_cast<N>(W) ? Raw<W, S>(0) : static_cast<Raw<W, S>>(static_cast<Unsigned<W>>(x) << n);
}
template <int W, bool S, class T, class N>
AP_EXPRESSION Raw<W, S> shift_right(T x, N n) {
  return n < static_cast<N>(W) ? static_cast<Raw<W, S>>(x >> n)
         : S                   ? static_cast<Raw<W, S>>(x >> (W - 1))
                               : 0;
}

template <class A>
using ShiftedType = decltype(shifted_type(std::declval<const A&>()));

/// A shift distance n; a negative one shifts the other way.
template <class N>
struct Distance {
  typedef ShapeOf<N> shape;
  static const int W = larger(shape::W, 32);
  typedef Unsigned<W> type;
  static AP_EXPRESSION bool backward(const N& n) { return shape::S && raw(n) < 0; }
  static AP_EXPRESSION type magnitude(const N& n) {
    return backward(n) ? -static_cast<type>(raw(n)) : static_cast<type>(raw(n));
  }
};
#define AP_SHIFT(symbol, forward, reverse)                                                           \
  template <class A, class N, class = IfOperands<A, N>, class = IfNotFixed<N>>                       \
  AP_EXPRESSION ShiftedType<A> operator symbol(const A & a, const N & n) {                           \
    typedef ShapeOf<A> s;                                                                            \
    return ShiftedType<A>(FromBits(), Distance<N>::backward(n)                                       \
                                          ? reverse<s::W, s::S>(raw(a), Distance<N>::magnitude(n))   \
                                          : forward<s::W, s::S>(raw(a), Distance<N>::magnitude(n))); \
  }
AP_SHIFT(<<, shift_left, shift_right)
AP_SHIFT(>>, shift_right, shift_left)
#undef AP_SHIFT

#define AP_COMPOUND(symbol)                                                \
  template <class A, class B, class = IfWord<A>, class = IfOperands<A, B>> \
  AP_INLINE A& operator symbol##=(A & a, const B & b) {                    \
    return a = a symbol b;                                                 \
  }
AP_COMPOUND(+)
AP_COMPOUND(-)
AP_COMPOUND(*)
AP_COMPOUND(/)
AP_COMPOUND(%)
AP_COMPOUND(&)
AP_COMPOUND(|)
AP_COMPOUND(^)
AP_COMPOUND(<<)
AP_COMPOUND(>>)
#undef AP_COMPOUND

template <class A, class = IfWord<A>>
AP_INLINE A& operator++(A& a) {
  return a += true;
}
template <class A, class = IfWord<A>>
AP_INLINE A& operator--(A& a) {
  return a -= true;
}
template <class A, class = IfWord<A>>
AP_INLINE A operator++(A& a, int) {
  const A before = a;
  ++a;
  return before;
}
template <class A, class = IfWord<A>>
AP_INLINE A operator--(A& a, int) {
  const A before = a;
  --a;
  return before;
}

/// (a, b): the bits of a above the bits of b, as a value, or as a target when both can be assigned.
template <class A, class B, class = IfOperands<Plain<A>, Plain<B>>>
AP_INLINE Concatenation<A, B> operator,(A&& a, B&& b) {
  return Concatenation<A, B>(part(std::forward<A>(a)), part(std::forward<B>(b)));
}

}  // namespace ap_detail

#endif
