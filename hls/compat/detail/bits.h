/// A word of W bits, base of all arbitrary-precision types: what can be done to its bits, wherever the point
/// is.
#ifndef AP_DETAIL_BITS_H
#define AP_DETAIL_BITS_H

#include "references.h"

namespace ap_detail {

template <int W, bool S>
struct Bits {
  static_assert(W > 0, "an arbitrary-precision type needs a width of at least one bit");
  static const int width = W;
  static const bool sign_flag = S;

  Unsigned<W> V;  ///< The bits, under their Vitis name. Uninitialised by default, as a register is.

  Bits() = default;
  template <class T>
  AP_EXPRESSION Bits(FromBits, T bits) : V(static_cast<Unsigned<W>>(bits)) {}

  /// The bits read as a number, two's complement when S.
  AP_EXPRESSION Raw<W, S> raw() const { return number(std::integral_constant<bool, S && W == 1>()); }

  AP_EXPRESSION int length() const { return W; }
  AP_EXPRESSION bool is_zero() const { return V == 0; }
  AP_EXPRESSION bool is_neg() const { return S && (V >> (W - 1)) != 0; }

  AP_EXPRESSION bool bit(int i) const { return (V >> checked("bit", i, W) & 1) != 0; }
  AP_EXPRESSION bool operator[](int i) const { return bit(i); }
  AP_INLINE ap_bit_ref<W, S> bit(int i) { return ap_bit_ref<W, S>(*this, i); }
  AP_INLINE ap_bit_ref<W, S> operator[](int i) { return bit(i); }

  /// Bits hi to lo, both included, hi >= lo. The length is taken from the indices as they come: there a + 7 -
  /// a is 7 for every compiler, which it no longer is once both have been cut to int.
  template <class H, class L>
  AP_INLINE ap_range_ref<W, S> range(const H& hi, const L& lo) {
    return ap_range_ref<W, S>(*this, static_cast<int>(lo), static_cast<int>(hi - lo) + 1);
  }
  template <class H, class L>
  AP_INLINE const ap_range_ref<W, S> range(const H& hi, const L& lo) const {
    return const_cast<Bits&>(*this).range(hi, lo);
  }
  template <class H, class L>
  AP_INLINE ap_range_ref<W, S> operator()(const H& hi, const L& lo) {
    return range(hi, lo);
  }
  template <class H, class L>
  AP_INLINE const ap_range_ref<W, S> operator()(const H& hi, const L& lo) const {
    return range(hi, lo);
  }
  AP_INLINE ap_range_ref<W, S> range() { return range(W - 1, 0); }
  AP_INLINE const ap_range_ref<W, S> range() const { return range(W - 1, 0); }

  AP_EXPRESSION bool and_reduce() const { return V == ones<W>(W); }
  AP_EXPRESSION bool nand_reduce() const { return !and_reduce(); }
  AP_EXPRESSION bool or_reduce() const { return V != 0; }
  AP_EXPRESSION bool nor_reduce() const { return V == 0; }
  AP_EXPRESSION bool xor_reduce() const { return Halves<W>::parity(V); }
  AP_EXPRESSION bool xnor_reduce() const { return !xor_reduce(); }

 private:
  AP_EXPRESSION Raw<W, S> number(std::false_type) const { return static_cast<Raw<W, S>>(V); }
  AP_EXPRESSION Raw<W, S> number(std::true_type) const { return V ? -1 : 0; }
};

}  // namespace ap_detail

#endif
