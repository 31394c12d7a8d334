/// The words under the arbitrary-precision types: _BitInt of the exact width, and what is done to bare words.
#ifndef AP_DETAIL_RAW_H
#define AP_DETAIL_RAW_H

#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

/// Quantisation: what becomes of bits below the last one kept.
enum ap_q_mode {
  AP_RND,          ///< To nearest, ties to plus infinity.
  AP_RND_ZERO,     ///< To nearest, ties to zero.
  AP_RND_MIN_INF,  ///< To nearest, ties to minus infinity.
  AP_RND_INF,      ///< To nearest, ties away from zero.
  AP_RND_CONV,     ///< To nearest, ties to even.
  AP_TRN,          ///< To minus infinity.
  AP_TRN_ZERO      ///< To zero.
};

/// Overflow: what becomes of values outside the range.
enum ap_o_mode {
  AP_SAT,       ///< The nearest end of the range.
  AP_SAT_ZERO,  ///< Zero.
  AP_SAT_SYM,   ///< As AP_SAT, but the least signed value is minus the greatest one.
  AP_WRAP,      ///< High bits are dropped; with N > 0 the top N bits saturate and the others wrap.
  AP_WRAP_SM    ///< Sign-magnitude wrap; signed types only.
};

template <int W>
struct ap_int;
template <int W>
struct ap_uint;
template <int W, int I, ap_q_mode Q = AP_TRN, ap_o_mode O = AP_WRAP, int N = 0>
struct ap_fixed;
template <int W, int I, ap_q_mode Q = AP_TRN, ap_o_mode O = AP_WRAP, int N = 0>
struct ap_ufixed;
template <int W, bool S>
struct ap_int_base;
template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
struct ap_fixed_base;

/// Every function of the types is an expression that folds; the debugger steps over it, and code that comes
/// from it carries the user's line. The System V convention would take words of 65 to 128 bits apart at every
/// call, which LLVM does not join again after inlining; the Microsoft convention passes them whole.
#ifdef __x86_64__
#define AP_WHOLE_WORDS __attribute__((ms_abi))
#else
#define AP_WHOLE_WORDS
#endif
#define AP_INLINE AP_WHOLE_WORDS __attribute__((always_inline, nodebug)) inline
#define AP_EXPRESSION AP_INLINE constexpr

namespace ap_detail {

template <class D, int W>
struct Reference;
template <int W, bool S>
struct Bits;

/// The number in a word of W bits. Clang has no signed _BitInt(1), whose values would be 0 and -1.
template <int W, bool S>
struct RawType {
  typedef _BitInt(W) type;
};
template <int W>
struct RawType<W, false> {
  typedef unsigned _BitInt(W) type;
};
template <>
struct RawType<1, true> {
  typedef _BitInt(2) type;
};
template <int W, bool S>
using Raw = typename RawType<W, S>::type;
/// Local variables of this type must not be const: Clang 19 crashes on some widths above 128.
template <int W>
using Unsigned = unsigned _BitInt(W);

/// Selects the constructors that take the bits as they are.
struct FromBits {};

AP_EXPRESSION int larger(int a, int b) { return a > b ? a : b; }
AP_EXPRESSION int smaller(int a, int b) { return a < b ? a : b; }

/// The low `count` bits set, 1 <= count <= W.
template <int W>
AP_EXPRESSION Unsigned<W> ones(int count) {
  return static_cast<Unsigned<W>>(~Unsigned<W>(0)) >> (W - count);
}

template <int W>
struct Halves {
  static const int low = (W + 1) / 2, high = W / 2;
  static AP_EXPRESSION bool parity(Unsigned<W> x) {
    return Halves<low>::parity(static_cast<Unsigned<low>>(x ^ (x >> low)));
  }
  static AP_EXPRESSION Unsigned<W> reverse(Unsigned<W> x) {
    return static_cast<Unsigned<W>>(Halves<low>::reverse(static_cast<Unsigned<low>>(x))) << high |
           Halves<high>::reverse(static_cast<Unsigned<high>>(x >> low));
  }
};
template <>
struct Halves<1> {
  static AP_EXPRESSION bool parity(Unsigned<1> x) { return x != 0; }
  static AP_EXPRESSION Unsigned<1> reverse(Unsigned<1> x) { return x; }
};

/// Stops a C simulation that reaches outside a value. Hardware has no such check.
#ifdef __SYNTHESIS__
AP_EXPRESSION int checked(const char*, int index, int) { return index; }
#else
[[noreturn]] inline void stop(const char* what, int index, int width) {
  std::fprintf(stderr, "%s: index %d is outside 0..%d; correct the index or widen the value.\n", what, index,
               width - 1);
  std::abort();
}
AP_EXPRESSION int checked(const char* what, int index, int width) {
  return index >= 0 && index < width ? index : (stop(what, index, width), 0);
}
#endif

}  // namespace ap_detail

#endif
