/// Bird's eye: contact points on the floor (ICVS paper, eq. 14-15, for the contact points alone).
///
/// (x, y) = (X / Z, Y / Z) with X, Y, Z linear in the contact's (u, v): metres in the robot frame, Q8.16. One
/// pair of multipliers forms Z, X and Y of a contact in three successive cycles; the division is
/// reciprocal.h's. With the map packed as parameters.h says, x and y are within 2^-15 of themselves and 2^-14
/// m / Z of the exact quotient.
///
/// Dropped, since the floor is not seen there or not resolved: Z <= 2^-4 (the horizon, beyond it, and farther
/// than about 16 times what the centre of the ROI sees), Z >= 8, and |x| or |y| of 128 m and more.
///
/// Three cycles a contact, latency ~16 cycles. DSP48E1: 4 for the pair, 2 for the division.
#ifndef FLOORLINE_HLS_BIRDSEYE_H
#define FLOORLINE_HLS_BIRDSEYE_H

#include "hls_stream.h"
#include "parameters.h"
#include "reciprocal.h"
#include "types.h"

namespace floorline {

/// Whether a value of the wider type Wide survives in `BITS` bits, signed.
template <int BITS, typename Wide>
inline bool fits(const Wide& value) {
#pragma HLS INLINE
  return ap_int<BITS>(value) == value;
}

/// per_u * u + per_v * v + start, with factors cut at bit 17: each product with the addition behind it is
/// then one DSP48E1.
inline ap_int<47> linear(ap_int<32> per_u, Coordinate u, ap_int<32> per_v, Size v, ap_int<32> start) {
#pragma HLS INLINE
  const int CUT = 17;
  const ap_uint<CUT> u_low = per_u, v_low = per_v;
  const ap_int<32 - CUT> u_high = per_u >> CUT, v_high = per_v >> CUT;
  const ap_int<36> low = start + u_low * u + v_low * v;
  const ap_int<47 - CUT> high = (low >> CUT) + u_high * u + v_high * v;
  return (ap_int<47>(high) << CUT) + ap_uint<CUT>(low);
}

/// Contacts of one frame, up to and including `end` -> their floor points, in the same order, and `end`.
inline void birdseye(hls::stream<Contact>& contacts, hls::stream<FloorPoint>& points,
                     const ProjectiveMap& map) {
  const ap_uint<2> DENOMINATOR = 0, FORWARD = 1, LEFT = 2;
  ap_uint<2> row = DENOMINATOR;
  Contact contact = {0, 0, 0, 0, 0, 0};
  Reciprocal denominator = {0, 0, false};
  ap_uint<1> on_floor = 0;
  ap_int<24> x = 0;
  bool last = false;
ROWS:
  while (!last) {
#pragma HLS PIPELINE II = 1
    if (row == DENOMINATOR) contact = contacts.read();
    const ap_int<32> per_u = row == DENOMINATOR ? map.zu : row == FORWARD ? map.xu : map.yu;
    const ap_int<32> per_v = row == DENOMINATOR ? map.zv : row == FORWARD ? map.xv : map.yv;
    // reciprocal() takes Z less one LSB.
    const ap_int<32> start = row == DENOMINATOR ? ap_int<32>(map.z1 - 1) : row == FORWARD ? map.x1 : map.y1;
    const ap_int<47> sum = linear(per_u, contact.u, per_v, contact.v, start);

    // Q14.18 rounded to the 25 bits of a multiplier, Q11.14; the quotient then has 14 + 13 - 11 fraction
    // bits.
    const ap_int<43> numerator = (sum + 8) >> 4;
    const ap_int<32> metres = quotient<11>(ap_int<25>(numerator), denominator);
    const Reciprocal found = reciprocal(ap_int<32>(sum));
    if (row == DENOMINATOR) denominator = found;
    // & without branches: a branch on on_floor would make the next denominator wait for it.
    const ap_uint<1> divides = found.valid;
    const ap_uint<1> sum_fits = fits<32>(sum);
    const ap_uint<1> numerator_fits = fits<25>(numerator);
    const ap_uint<1> metres_fit = fits<24>(metres);
    on_floor = row == DENOMINATOR ? ap_uint<1>(divides & sum_fits)
                                  : ap_uint<1>(on_floor & numerator_fits & metres_fit);

    if (row == LEFT && contact.end) {
      const FloorPoint end = {0, 0, 0, 0, 0, 0, 0, 1};
      points.write(end);
    } else if (row == LEFT && on_floor) {
      const FloorPoint point = {contact.line,       contact.u,       contact.v, contact.rows, x,
                                ap_int<24>(metres), contact.clipped, 0};
      points.write(point);
    }
    x = metres;
    last = row == LEFT && contact.end;
    row = row == LEFT ? DENOMINATOR : ap_uint<2>(row + 1);
  }
}

}  // namespace floorline

#endif
