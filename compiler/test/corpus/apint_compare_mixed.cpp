// Comparison of signed with unsigned of different widths.
// top: apint_compare_mixed
#include "ap_int.h"
ap_uint<4> apint_compare_mixed(ap_int<7> a, ap_uint<5> b) {
  ap_uint<4> r = 0;
  r[0] = a < b;
  r[1] = a >= b;
  r[2] = a == b;
  r[3] = a > 3;
  return r;
}
