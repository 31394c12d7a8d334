/// Quantisation and overflow: how any number becomes an ap_fixed of given format and modes.
#ifndef AP_DETAIL_CONVERSION_H
#define AP_DETAIL_CONVERSION_H

#include "operands.h"

namespace ap_detail {

template <int W, int I>
struct Value<W, I, true, true> {
  typedef ap_fixed<W, I> type;
};
template <int W, int I>
struct Value<W, I, false, true> {
  typedef ap_ufixed<W, I> type;
};

/// Whether the kept number goes up by one. half: the first bit dropped; rest: any of the others; odd: the
/// last kept.
AP_EXPRESSION bool rounds_up(ap_q_mode q, bool half, bool rest, bool negative, bool odd) {
  return q == AP_RND           ? half
         : q == AP_RND_ZERO    ? half && (rest || negative)
         : q == AP_RND_MIN_INF ? half && rest
         : q == AP_RND_INF     ? half && (rest || !negative)
         : q == AP_RND_CONV    ? half && (rest || odd)
         : q == AP_TRN_ZERO    ? negative && (half || rest)
                               : false;
}

/// Drops the low `Dropped` bits of x; the result has room for the carry.
template <int Dropped, ap_q_mode Q, int W, bool S>
struct Quantisation {
  static const int wide = larger(W, Dropped + 1) + !S;  // a signed word that holds x and all bits dropped
  static const int width = larger(W - Dropped, 1) + !S + 1;
  typedef _BitInt(wide) Wide;
  typedef _BitInt(width) type;

  static AP_EXPRESSION type of(Raw<W, S> x) {
    return static_cast<type>(static_cast<Wide>(x) >> Dropped) +
           static_cast<type>(round(static_cast<Wide>(x)));
  }

 private:
  static AP_EXPRESSION bool round(Wide x) {
    return rounds_up(Q, (x >> (Dropped - 1) & 1) != 0, (x & ((Wide(1) << (Dropped - 1)) - 1)) != 0, x < 0,
                     (x >> Dropped & 1) != 0);
  }
};

/// Fits q, a number in units of the target's last bit, into W bits. lost: bit W of the number before
/// rounding.
template <int W, bool S, ap_o_mode O, int N, int QW>
struct Overflow {
  static const int CW = larger(QW, W + 2);
  typedef _BitInt(CW) Wide;

  static AP_EXPRESSION Unsigned<W> of(Wide q, bool lost) {
    return O == AP_WRAP && N == 0          ? static_cast<Unsigned<W>>(q)
           : q > greatest() || q < least() ? outside(static_cast<Unsigned<W>>(q), q < 0, lost)
                                           : static_cast<Unsigned<W>>(q);
  }

 private:
  static AP_EXPRESSION Wide greatest() { return (Wide(1) << (W - S)) - 1; }
  static AP_EXPRESSION Wide least() { return !S ? 0 : -greatest() - (O != AP_SAT_SYM || W == 1); }

  static AP_EXPRESSION Unsigned<W> outside(Unsigned<W> bits, bool negative, bool lost) {
    return O == AP_SAT || O == AP_SAT_SYM ? static_cast<Unsigned<W>>(negative ? least() : greatest())
           : O == AP_SAT_ZERO             ? Unsigned<W>(0)
           : O == AP_WRAP                 ? saturated_top(bits, negative)
           : N == 0                       ? with_top(mirrored(bits, top(bits) != lost), 1, lost)
                                          : saturated_top(mirrored(bits, mirrors(bits, negative)), negative);
  }

  static const int saturated = smaller(N, W);
  static AP_EXPRESSION bool top(Unsigned<W> bits) { return (bits >> (W - 1)) != 0; }
  static AP_EXPRESSION bool mirrors(Unsigned<W> bits, bool negative) {
    return N == 1 ? top(bits) != negative : ((bits >> (W - larger(saturated, 1)) & 1) != 0) == negative;
  }
  static AP_EXPRESSION Unsigned<W> mirrored(Unsigned<W> bits, bool mirror) {
    return mirror ? static_cast<Unsigned<W>>(~bits) : bits;
  }
  /// The top `count` bits all set or all clear.
  static AP_EXPRESSION Unsigned<W> with_top(Unsigned<W> bits, int count, bool on) {
    return on ? bits | static_cast<Unsigned<W>>(ones<W>(count) << (W - count))
              : bits & static_cast<Unsigned<W>>(~(ones<W>(count) << (W - count)));
  }
  /// The top N bits at the end of the range: for signed types the sign and N - 1 bits of its opposite.
  static AP_EXPRESSION Unsigned<W> saturated_top(Unsigned<W> bits, bool negative) {
    return !S ? with_top(bits, larger(saturated, 1), true)
              : with_top(with_top(bits, larger(saturated, 1), !negative), 1, negative);
  }
};

template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
struct Conversion {
  static const int F = W - I;

  /// The bits of x, a number of SF fraction bits.
  template <int SF, int SW>
  static AP_EXPRESSION Unsigned<W> from(_BitInt(SW) x) {
    return convert<SF, SW, true>(x, std::integral_constant<bool, (SF > F)>());
  }
  template <int SF, int SW>
  static AP_EXPRESSION Unsigned<W> from(unsigned _BitInt(SW) x) {
    return convert<SF, SW, false>(x, std::integral_constant<bool, (SF > F)>());
  }

 private:
  template <int SF, int SW, bool SS>
  static AP_EXPRESSION Unsigned<W> convert(Raw<SW, SS> x, std::true_type) {
    typedef Quantisation<SF - F, Q, SW, SS> Quantised;
    return Overflow<W, S, O, N, Quantised::width>::of(Quantised::of(x), lost<SF - F + W, SW>(x));
  }
  template <int SF, int SW, bool SS>
  static AP_EXPRESSION Unsigned<W> convert(Raw<SW, SS> x, std::false_type) {
    typedef Overflow<W, S, O, N, SW + F - SF + !SS> Fitted;
    return Fitted::of(static_cast<typename Fitted::Wide>(x) * (typename Fitted::Wide(1) << (F - SF)),
                      lost<SF - F + W, SW>(x));
  }
  template <int Position, int SW, class T>
  static AP_EXPRESSION bool lost(T x) {
    return Position >= 0 && Position < SW && (x >> smaller(larger(Position, 0), SW - 1) & 1) != 0;
  }
};

template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
ap_fixed<W, I, Q, O, N> shifted_type(const ap_fixed_base<W, I, true, Q, O, N>&);
template <int W, int I, ap_q_mode Q, ap_o_mode O, int N>
ap_ufixed<W, I, Q, O, N> shifted_type(const ap_fixed_base<W, I, false, Q, O, N>&);

}  // namespace ap_detail

#endif
