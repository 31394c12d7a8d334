/// Reciprocal of a projective denominator, shared by frame_ring.h and birdseye.h: a division becomes one
/// multiplication that fits a DSP48E1 (25 x 18 bits, signed).
///
/// Z (Q4.28, 2^-4 < Z < 8) = m * 2^e with m in (1, 2]. 1 / m comes from a table of 128 chords: with d the
/// place within the chord, 1 / m = base - slope * d. Relative error below 2^-16, none where Z is a power of
/// two: a homography without perspective maps whole pixels to whole pixels. Feed-forward, one DSP.
#ifndef FLOORLINE_HLS_RECIPROCAL_H
#define FLOORLINE_HLS_RECIPROCAL_H

#include "ap_int.h"
#include "table.h"

namespace floorline {

/// 1 / Z = mantissa * 2^(4 - 17 - shift).
struct Reciprocal {
  ap_uint<17> mantissa;  ///< 1 / m, Q0.17, in [1/2, 1).
  ap_uint<3> shift;      ///< e + 4: 0 .. 6.
  bool valid;            ///< 2^-4 < Z < 8.
};

/// Word of chord i: base (19 bits, Q0.19) in bits 30:12, slope (12 bits, Q0.19 a chord) in bits 11:0.
struct ReciprocalChord {
  static const int COUNT = 128;

  static constexpr double at_start(int i) { return double(COUNT) / (COUNT + i); }

  /// A chord runs above the curve; half its greatest height above it is taken off, so that the error is
  /// centred. h^2 / 8 * f''(m), f'' = 2 / m^3, h = 1 / COUNT.
  static constexpr double half_height(int i) {
    return at_start(i) * at_start(i) * at_start(i) / (8.0 * COUNT * COUNT);
  }

  /// With what rounding needs: half a unit of the mantissa, less the half that cutting slope * d adds.
  static constexpr unsigned base(int i) {
    return unsigned((at_start(i) - half_height(i)) * (1 << 19) + 0.5 + 2 - 0.5);
  }

  static constexpr unsigned slope(int i) {
    return unsigned((at_start(i) - at_start(i + 1)) * (1 << 19) + 0.5);
  }

  static constexpr unsigned at(int i) { return base(i) << 12 | slope(i); }
};

/// z_less_one: Z less one LSB, which callers take off a constant term for nothing. It makes m = 2 of a power
/// of two, whose reciprocal is exact, where that of m = 1 would need a bit more.
inline Reciprocal reciprocal(ap_int<32> z_less_one) {
#pragma HLS INLINE
  Reciprocal result;
  result.valid = z_less_one >= (1 << 24);
  const ap_int<32> z = z_less_one;
  result.shift = z[30] ? 6 : z[29] ? 5 : z[28] ? 4 : z[27] ? 3 : z[26] ? 2 : z[25] ? 1 : 0;
  // The fraction of m: 7 bits choose the chord, 13 the place within it.
  const ap_uint<24> fraction = ap_uint<31>(z) >> result.shift;
  const ap_uint<32> chord = Table<ReciprocalChord, ReciprocalChord::COUNT>::word[fraction.range(23, 17)];
  const ap_uint<19> base = chord.range(30, 12);
  const ap_uint<12> slope = chord.range(11, 0);
  const ap_uint<13> place = fraction.range(16, 4);
  const ap_uint<25> drop = slope * place;
  result.mantissa = (base - (drop >> 13)) >> 2;
  return result;
}

/// numerator / Z, with 13 - DROP fraction bits more than the numerator has, rounded down. Meaningless when
/// not valid.
template <int DROP>
inline ap_int<43 - DROP> quotient(ap_int<25> numerator, const Reciprocal& denominator) {
#pragma HLS INLINE
  const ap_int<43> product = numerator * ap_int<18>(denominator.mantissa);
  return ap_int<43 - DROP>(product >> DROP) >> denominator.shift;
}

}  // namespace floorline

#endif
