/// Histogram and Otsu's threshold (ICVS paper, eq. 9-11): the grey level t that best splits a frame into two
/// classes, p <= t and p > t. The threshold of a frame is used on the next one.
///
/// With N pixels of sum S in the frame, q(t) pixels of sum s(t) in the lower class, the between-class
/// variance is proportional to d^2 / (q (N - q)), d = q S - N s. The answer is exact, in three steps:
///   pixels      count the grey levels while the frame passes;
///   scores      log2 of every t's variance, to within a proven error. What lies farther below the best score
///               than twice that error cannot be the best and is dropped; a few contenders remain;
///   contenders  are compared by cross multiplication, limb by limb.
/// Between two grey levels that occur every t makes the same split; the lowest of equals is taken. A frame of
/// a single grey level has no split: threshold 0.
///
/// II = 1. A frame takes width * height + 503 cycles, 54 a contender (mostly one to three), and 7 more for
/// one that is better than those before. The histogram is cleared while it is read; the first frame after a
/// reset waits 256 cycles until it is cleared.
/// Twelve DSPs.
#ifndef FLOORLINE_HLS_OTSU_H
#define FLOORLINE_HLS_OTSU_H

#include "histogram.h"
#include "hls_stream.h"
#include "table.h"
#include "types.h"

namespace floorline {
namespace otsu_scan {

/// Widths for frames of up to MAX_PIXELS pixels.
template <unsigned long MAX_PIXELS>
struct Widths {
  typedef typename HistogramTotals<MAX_PIXELS>::Count Count;  ///< q, N.
  typedef typename HistogramTotals<MAX_PIXELS>::Sum Sum;      ///< s, S.
  enum { COUNT = Count::width };
  typedef ap_uint<2 * COUNT - 2> Product;    ///< q (N - q) <= N^2 / 4.
  typedef ap_uint<2 * COUNT + 6> Deviation;  ///< d = q (N - q) times the distance of the class means.
};

/// A level whose score is too near the best one to tell them apart.
template <typename Widths>
struct Contender {
  Pixel level;
  typename Widths::Deviation deviation;
  typename Widths::Count below;  ///< q; N - q follows.
};

/// Word of chord i of log2(1 + x), x from i / 64 to (i + 1) / 64: base (17 bits, Q0.17) in bits 28:12, slope
/// (12 bits, Q0.19 a chord) in bits 11:0.
struct LogarithmChord {
  static const int COUNT = 256;

  /// atanh(z) / z for z^2 = z2 <= 1/9, to within 10^-7.
  static constexpr double atanh_ratio(double z2) {
    return 1 + z2 * (1 / 3. + z2 * (1 / 5. + z2 * (1 / 7. + z2 * (1 / 9. + z2 * (1 / 11. + z2 / 13)))));
  }

  /// log2(m) = 2 / ln 2 * atanh(z), z = (m - 1) / (m + 1), at the start m = 1 + i / 256 of the chord.
  static constexpr double at_start(int i) {
    return 2.8853900817779268 * i / (2 * COUNT + i) *
           atanh_ratio(double(i) * i / (double(2 * COUNT + i) * (2 * COUNT + i)));
  }

  /// A chord runs below the curve; half its greatest depth is added, so that the error is centred.
  /// h^2 / 8 * |f''(m)|, f'' = 1 / (ln 2 m^2), h = 1 / 256.
  static constexpr double half_depth(int i) {
    return 1.4426950408889634 / (16.0 * (COUNT + i) * (COUNT + i));
  }

  /// With half a unit for rounding and half a unit for what cutting slope * place drops.
  static constexpr unsigned base(int i) {
    return unsigned((at_start(i) + half_depth(i)) * (1 << 19) + 0.5 + 0.5);
  }

  static constexpr unsigned slope(int i) {
    return unsigned((at_start(i + 1) - at_start(i)) * (1 << 19) + 0.5);
  }

  static constexpr unsigned at(int i) { return base(i) << 12 | slope(i); }
};

typedef ap_uint<25> Logarithm;  ///< Q6.19.

/// Greatest error of logarithm(), in units of 2^-19.
const int LOGARITHM_ERROR = 3;

/// One step of normalising: up by as many digits of DIGIT bits as are 0 at the top, at most three; they are
/// added to `digits`, a number to the base 4.
template <int DIGIT, int BITS>
inline void shift_up(ap_uint<BITS>& mantissa, ap_uint<6>& digits) {
#pragma HLS INLINE
  const bool first = mantissa >> (BITS - DIGIT) == 0;
  const bool second = mantissa >> (BITS - 2 * DIGIT) == 0;
  const bool third = 3 * DIGIT < BITS && mantissa >> (BITS - 3 * DIGIT) == 0;
  const ap_uint<2> zeros = third ? 3 : second ? 2 : first ? 1 : 0;
  mantissa = mantissa << DIGIT * zeros;
  digits = digits << 2 | zeros;
}

/// log2(x), Q6.19, for x > 0.
template <int BITS>
inline Logarithm logarithm(ap_uint<BITS> x) {
#pragma HLS INLINE
  static_assert(BITS > 32, "The first step of normalising looks at 32 bits.");
  ap_uint<BITS> mantissa = x;  // shifted up until its first bit is set
  ap_uint<6> shifts = 0;
  shift_up<16>(mantissa, shifts);
  shift_up<4>(mantissa, shifts);
  shift_up<1>(mantissa, shifts);
  const ap_uint<21> fraction = mantissa >> (BITS - 1 - 21);
  const ap_uint<32> chord = Table<LogarithmChord, LogarithmChord::COUNT>::word[fraction.range(20, 13)];
  const ap_uint<19> base = chord.range(30, 12);
  const ap_uint<12> slope = chord.range(11, 0);
  const ap_uint<13> place = fraction.range(12, 0);
  const ap_uint<25> rise = slope * place;
  const ap_uint<6> exponent = BITS - 1 - shifts;
  return (Logarithm(exponent) << 19) + base + (rise >> 13);
}

const int LIMB_BITS = 17;  ///< A product of two limbs is one DSP48E1.
typedef ap_uint<LIMB_BITS> Limb;

/// Six limbs; two more, so that every index of three bits is one.
struct SixLimbs {
  Limb limb[8];
};

/// Steps through the partial products of a long multiplication whose first factor has three limbs, column by
/// column: term i of column k is x[i] * y[k - i].
struct LongMultiplication {
  ap_uint<4> column;
  ap_uint<2> term;

  LongMultiplication() : column(0), term(0) {}

  bool column_start() const { return term == 0; }
  bool column_end() const { return term == 2; }

  /// One partial product of a second factor of three limbs.
  ap_uint<2 * LIMB_BITS> product(const Limb* x, const Limb* y) const {
#pragma HLS INLINE
    const ap_int<5> limb = column - term;
    return x[term] * (limb >= 0 && limb < 3 ? y[limb] : Limb(0));
  }

  /// One partial product of a second factor of six limbs.
  ap_uint<2 * LIMB_BITS> product(const Limb* x, const SixLimbs& y) const {
#pragma HLS INLINE
    const ap_int<5> limb = column - term;
    return (limb >= 0 && limb < 6 ? x[term] : Limb(0)) * y.limb[ap_uint<3>(limb)];
  }

  void advance() {
    if (column_end()) column = column + 1;
    term = column_end() ? ap_uint<2>(0) : ap_uint<2>(term + 1);
  }
};

/// The limbs of a value, lowest first.
template <int BITS>
inline void split(ap_uint<BITS> value, Limb* limbs) {
#pragma HLS INLINE
  const ap_uint<3 * LIMB_BITS> extended = value;
  limbs[0] = extended.range(LIMB_BITS - 1, 0);
  limbs[1] = extended.range(2 * LIMB_BITS - 1, LIMB_BITS);
  limbs[2] = extended.range(3 * LIMB_BITS - 1, 2 * LIMB_BITS);
}

inline void square(const Limb* value, SixLimbs& result) {
#pragma HLS INLINE
  ap_uint<2 * LIMB_BITS + 2> sum = 0;
SQUARE:
  for (LongMultiplication at; at.column < 6; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 18 max = 18
    const ap_uint<2 * LIMB_BITS + 2> carried = at.column_start() ? sum >> LIMB_BITS : sum;
    sum = carried + at.product(value, value);
    if (at.column_end()) result.limb[at.column] = sum;
  }
}

/// Whether fraction a exceeds fraction b: whether the difference of the cross products is positive. Its limbs
/// come lowest first; what is left when they are gone is 0 or -1, its sign.
inline bool greater(const SixLimbs& a_numerator, const Limb* a_denominator, const SixLimbs& b_numerator,
                    const Limb* b_denominator) {
#pragma HLS INLINE
  ap_int<2 * LIMB_BITS + 3> difference = 0;
  bool differs = false;
COMPARE:
  for (LongMultiplication at; at.column < 9; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 27 max = 27
    const ap_int<2 * LIMB_BITS + 1> term =
        at.product(b_denominator, a_numerator) - at.product(a_denominator, b_numerator);
    const ap_int<2 * LIMB_BITS + 3> carried = at.column_start() ? difference >> LIMB_BITS : difference;
    difference = carried + term;
    if (at.column_end() && Limb(difference) != 0) differs = true;
  }
  return differs && difference >= 0;
}

/// The first of the best contenders; 0 when there is none.
template <typename Widths>
inline Pixel best_contender(const Contender<Widths>* contenders, ap_uint<9> size,
                            typename Widths::Count total) {
#pragma HLS INLINE
  // The fraction d^2 / (q (N - q)) of a contender and of the best one so far, in limbs, lowest first.
  SixLimbs numerator, best_numerator;
  Limb denominator[3], best_denominator[3];
  Pixel best_level = 0;
CONTENDERS:
  for (ap_uint<9> i = 0; i < size; ++i) {
#pragma HLS LOOP_TRIPCOUNT min = 0 max = 256
    const Contender<Widths> contender = contenders[i];
    Limb deviation[3];
    split(contender.deviation, deviation);
    split(typename Widths::Product(contender.below * (total - contender.below)), denominator);
    square(deviation, numerator);
    if (i == 0 || greater(numerator, denominator, best_numerator, best_denominator)) {
      best_level = contender.level;
    KEEP:
      for (int limb = 0; limb < 6; ++limb) {
#pragma HLS PIPELINE II = 1
        best_numerator.limb[limb] = numerator.limb[limb];
        if (limb < 3) best_denominator[limb] = denominator[limb];
      }
    }
  }
  return best_level;
}

}  // namespace otsu_scan

/// in: width * height pixels. out: the same ones. thresholds: one a frame, before its first pixel: the
/// threshold found on the frame before, 0 on the first frame.
template <int MAX_WIDTH, int MAX_HEIGHT>
void otsu(hls::stream<Pixel>& in, hls::stream<Pixel>& out, hls::stream<Pixel>& thresholds, Size width,
          Size height) {
  using namespace otsu_scan;
  typedef Widths<MAX_WIDTH * MAX_HEIGHT> W;
  typedef typename W::Count Count;
  static_assert(W::Deviation::width <= 3 * LIMB_BITS, "MAX_WIDTH * MAX_HEIGHT must be below 2^22.");
  static Count histogram[LEVELS];
#pragma HLS RESOURCE variable = histogram core = RAM_S2P_BRAM
  static Pixel threshold = 0;
  thresholds.write(threshold);

  // A reset in mid-frame leaves counts of that frame behind.
  static ap_uint<1> cleared = 0;
  if (!cleared) {
  CLEAR:
    for (int level = 0; level < LEVELS; ++level) {
#pragma HLS PIPELINE II = 1
      histogram[level] = 0;
    }
  }
  cleared = 0;

  const HistogramTotals<MAX_WIDTH * MAX_HEIGHT> totals =
      count_levels<MAX_WIDTH, MAX_HEIGHT>(in, out, histogram, width, height);
  const Count total = totals.pixels;

  // Two steps a level, so that one logarithm does: first d, then q (N - q).
  const int WINDOW = 2 * (2 + 1) * LOGARITHM_ERROR;
  Contender<W> contenders[256];
#pragma HLS AGGREGATE variable = contenders
  ap_uint<9> contender_count = 0;
  bool occurs = false;  // the level does
  Count below = 0;
  ap_int<W::Deviation::width + 2> deviation = 0;
  ap_int<W::Sum::width + 1> excess = totals.sum;  // S - N t
  Logarithm deviation_logarithm = 0;
  ap_int<27> best_score = -(1 << 25);
SCORES:
  for (ap_uint<10> step = 0; step < 512; ++step) {
#pragma HLS PIPELINE II = 1
// True: every bin is read and cleared once.
#pragma HLS DEPENDENCE variable = histogram inter false
    const Pixel level = step >> 1;
    const bool deviation_turn = !step[0];
    const typename W::Product product = below * (total - below);
    const Contender<W> contender = {level, deviation, below};
    if (deviation_turn) {
      const Count count = histogram[level];
      histogram[level] = 0;
      occurs = count != 0;
      below = below + count;
      deviation = deviation + count * excess;
      excess = excess - total;
    }
    const typename W::Deviation operand =
        deviation_turn ? typename W::Deviation(deviation) : typename W::Deviation(product);
    const Logarithm result = logarithm<W::Deviation::width>(operand);
    if (deviation_turn) {
      deviation_logarithm = result;
    } else if (occurs && below != total) {
      const ap_int<27> score = (ap_int<27>(deviation_logarithm) << 1) - result;
      const ap_int<27> surely_above = score - WINDOW;
      const ap_int<27> maybe_above = score + WINDOW;
      const bool restarts = surely_above > best_score;
      if (maybe_above >= best_score) {
        contenders[restarts ? Pixel(0) : Pixel(contender_count)] = contender;
        contender_count = restarts ? ap_uint<9>(1) : ap_uint<9>(contender_count + 1);
      }
      if (score > best_score) best_score = score;
    }
  }
  threshold = best_contender<W>(contenders, contender_count, total);
  cleared = 1;
}

}  // namespace floorline

#endif
