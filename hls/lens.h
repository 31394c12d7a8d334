/// Lens rectification (ICVS paper, the address generator): takes the distortion of the lens out of the image.
///
/// Pixel (u, v) of the rectified image is read in the camera's image at
///   u + (u - cx) (g + t) + fx p2 r^2,  v + (v - cy) (g + t) + fy p1 r^2,
///   g = k1 r^2 + k2 r^4 + k3 r^6,  t = 2 (p1 y + p2 x),  r^2 = x^2 + y^2:
/// OpenCV's radial and tangential model, in which t is linear in u and v and so costs additions only. The
/// rectified image has the camera matrix of the camera. Coordinates are within 0.05 px for distortions of up
/// to 100 px. A ring holds the rows that distortion may reach: RADIUS rows on either side.
///
/// Sample: nearest pixel or bilinear, by BILINEAR. Pixels outside the image or farther than RADIUS rows away
/// read 0, each pixel of a bilinear cell by itself.
///
/// II = 1; a frame takes width * (height + RADIUS + 2) + depth cycles, depth ~20: row v comes out while row
/// v + RADIUS + 2 goes in. Least width in hardware: 32. Nine DSPs, twelve when bilinear.
#ifndef FLOORLINE_HLS_LENS_H
#define FLOORLINE_HLS_LENS_H

#include "banks.h"
#include "hls_stream.h"
#include "parameters.h"
#include "raster.h"

namespace floorline {

/// A place in the camera's image, Q13.8 pixels.
struct LensPoint {
  ap_int<22> x;
  ap_int<22> y;
};

/// Walks over the rectified image and tells where each pixel lies in the camera's image.
struct LensMap {
  LinearWalk x;     ///< x / s, Q2.30.
  LinearWalk y;     ///< y / s, Q2.30.
  LinearWalk skew;  ///< t, Q2.30.

  explicit LensMap(const LensParameters& lens)
      : x(lens.x_first, lens.x_step, 0),
        y(lens.y_first, 0, lens.y_step),
        skew(lens.skew_first, lens.skew_u, lens.skew_v) {}

  void advance(bool row_end) {
#pragma HLS INLINE
    x.advance(row_end);
    y.advance(row_end);
    skew.advance(row_end);
  }

  /// (u, v): where the walk stands. Every product is one DSP48E1, 25 x 18 bits.
  LensPoint point(Size u, Size v, const LensParameters& lens) const {
#pragma HLS INLINE
    const ap_int<18> x_short = x.value >> 14;  // Q2.16
    const ap_int<18> y_short = y.value >> 14;
    const ap_int<18> r2 = (x_short * x_short + y_short * y_short) >> 16;  // Q2.16, at most 1
    const ap_int<25> cubic = lens.radial2 + (lens.radial3 * r2 >> 16);    // Q4.21
    const ap_int<25> square = lens.radial1 + (cubic * r2 >> 16);
    const ap_int<25> stretch = (square * r2 >> 16) + (skew.value >> 9);
    const ap_int<18> from_centre_u = (ap_int<18>(u) << 6) - lens.centre_u;  // Q12.6
    const ap_int<18> from_centre_v = (ap_int<18>(v) << 6) - lens.centre_v;
    LensPoint point;
    point.x = (ap_int<22>(u) << 8) + (from_centre_u * stretch >> 19) + (lens.shift_u * r2 >> 24);
    point.y = (ap_int<22>(v) << 8) + (from_centre_v * stretch >> 19) + (lens.shift_v * r2 >> 24);
    return point;
  }
};

/// a + (b - a) * weight, weight Q0.8; 8 fraction bits more than a and b have.
template <int BITS>
inline ap_uint<BITS + 8> blend(ap_uint<BITS> a, ap_uint<BITS> b, ap_uint<8> weight) {
#pragma HLS INLINE
  const ap_int<BITS + 1> rise = b - a;
  return (ap_int<BITS + 10>(a) << 8) + rise * weight;
}

/// The four pixels around a point, weighted by its fractions; row and column parity say which is the upper
/// left.
inline Pixel bilinear(const BankCell& cell, ap_uint<1> top, ap_uint<1> left, ap_uint<8> right_weight,
                      ap_uint<8> bottom_weight) {
#pragma HLS INLINE
  const ap_uint<1> bottom = ~top;
  const ap_uint<1> right = ~left;
  const ap_uint<16> upper = blend<8>(pixel_of(cell, top, left), pixel_of(cell, top, right), right_weight);
  const ap_uint<16> lower =
      blend<8>(pixel_of(cell, bottom, left), pixel_of(cell, bottom, right), right_weight);
  return (blend<16>(upper, lower, bottom_weight) + (1 << 15)) >> 16;
}

/// in: width * height pixels of the camera. out: as many of the rectified image.
template <int MAX_WIDTH, int MAX_HEIGHT, int RADIUS, bool BILINEAR>
void lens(hls::stream<Pixel>& in, hls::stream<Pixel>& out, Size width, Size height,
          const LensParameters& parameters) {
  static_assert(MAX_WIDTH % 2 == 0, "MAX_WIDTH must be even: the ring's banks hold every second column.");
  // Rows v - RADIUS .. v + RADIUS, one between them and the row that is written, and that row; made even.
  const int RING_ROWS = 2 * RADIUS + 4;
  const int PITCH = MAX_WIDTH / 2;
  const int DELAY = RADIUS + 2;
  const int BANK_SIZE = RING_ROWS / 2 * PITCH;
  static Pixel even_even[BANK_SIZE];
  static Pixel even_odd[BANK_SIZE];
  static Pixel odd_even[BANK_SIZE];
  static Pixel odd_odd[BANK_SIZE];
#pragma HLS RESOURCE variable = even_even core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = even_odd core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = odd_even core = RAM_S2P_BRAM
#pragma HLS RESOURCE variable = odd_odd core = RAM_S2P_BRAM

  LensMap map(parameters);
  Size write_row = 0;   // ring row of the row that comes in
  Size centre_row = 0;  // ring row of the row that comes out
  const Size last_column = width - 1;
  const Size last_row = height - 1;

PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT + DELAY> at(width, height + DELAY); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * (MAX_HEIGHT + DELAY)
// True: a row is read a row after it was written at the earliest, and written again a row after it was last
// read.
#pragma HLS DEPENDENCE variable = even_even inter false
#pragma HLS DEPENDENCE variable = even_odd inter false
#pragma HLS DEPENDENCE variable = odd_even inter false
#pragma HLS DEPENDENCE variable = odd_odd inter false
    const bool row_end = at.at_row_end();
    if (at.v >= DELAY) {
      const Size v = at.v - DELAY;
      const LensPoint point = map.point(at.u, v, parameters);
      const int HALF = BILINEAR ? 0 : 128;
      const ap_int<22> x = point.x + HALF;
      const ap_int<22> y = point.y + HALF;
      const ap_int<14> left = x >> 8;
      const ap_int<14> rise = (y >> 8) - v;  // of the cell's upper row over row v
      const ap_int<14> top = y >> 8;

      const bool left_inside = left >= 0 && left <= last_column;
      const bool right_inside = BILINEAR && left >= -1 && left < last_column;
      const bool top_inside = top >= 0 && top <= last_row && rise >= -RADIUS && rise <= RADIUS;
      const bool bottom_inside =
          BILINEAR && top >= -1 && top < last_row && rise >= -RADIUS - 1 && rise < RADIUS;
      const Size ring_top = wrapped<RING_ROWS>(centre_row + rise);
      const Size ring_bottom = row_below<RING_ROWS>(ring_top);
      const BankAxis rows = bank_axis(ring_top, top_inside, ring_bottom, bottom_inside);
      const BankAxis columns = bank_axis(left, left_inside, left + 1, right_inside);
      const BankCell cell = load<PITCH>(even_even, even_odd, odd_even, odd_odd, rows, columns);
      const ap_uint<8> right_weight = BILINEAR ? x.range(7, 0).to_uint() : 0;
      const ap_uint<8> bottom_weight = BILINEAR ? y.range(7, 0).to_uint() : 0;
      out.write(bilinear(cell, ring_top[0], left[0], right_weight, bottom_weight));
      map.advance(row_end);
      if (row_end) centre_row = row_below<RING_ROWS>(centre_row);
    }
    if (at.v < height) store<PITCH>(even_even, even_odd, odd_even, odd_odd, write_row, at.u, in.read());
    if (row_end) write_row = row_below<RING_ROWS>(write_row);
  }
}

}  // namespace floorline

#endif
