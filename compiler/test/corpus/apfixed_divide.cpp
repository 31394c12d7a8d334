// Fixed-point division.
// top: apfixed_divide
#include "ap_fixed.h"
ap_fixed<16, 8> apfixed_divide(ap_fixed<12, 6> a, ap_ufixed<7, 3> b) {
  if (b == 0) return 0;
  return a / b;
}
