// Arrays that a loop fills with constants before they are read: tables, without a cycle to fill them.
// top: array_filled_with_constants
// expect: memory ramp rom 128x17
// expect: memory squares rom 128x24
#include <cmath>
#include "ap_fixed.h"
typedef ap_fixed<24, 12> Value;
static void fill(Value table[128], double scale) {
  for (int i = 0; i < 128; ++i) table[i] = scale * std::sqrt(i);
}
Value array_filled_with_constants(unsigned char place) {
  Value ramp[128];
  static Value squares[128];
  fill(ramp, 1.5);
  fill(squares, -3.0);
  return ramp[place & 127] + squares[place >> 1];
}
