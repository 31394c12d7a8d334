// CORDIC rotation in fixed point.
// top: textbook_cordic
// expect: operators multiply=0
#include "ap_fixed.h"
typedef ap_fixed<18, 3> Angle;
void textbook_cordic(ap_fixed<12, 1> fraction, Angle& sine, Angle& cosine) {
  static const Angle table[12] = {0.7853981, 0.4636476, 0.2449786, 0.1243549, 0.0624188, 0.0312398,
                                  0.0156237, 0.0078123, 0.0039062, 0.0019531, 0.0009765, 0.0004882};
  Angle x = 0.6072529, y = 0, z = fraction;
ROTATE:
  for (int i = 0; i < 12; ++i) {  // expect: loop II=1 cycles=12
#pragma HLS PIPELINE
    Angle dx = y >> i, dy = x >> i;
    if (z >= 0) {
      x -= dx;
      y += dy;
      z -= table[i];
    } else {
      x += dx;
      y -= dy;
      z += table[i];
    }
  }
  sine = y;
  cosine = x;
}
