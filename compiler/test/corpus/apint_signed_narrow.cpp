// Sign extension and wrap at odd widths.
// top: apint_signed_narrow
#include "ap_int.h"
ap_int<11> apint_signed_narrow(ap_int<5> a, ap_int<9> b) {
  ap_int<6> t = a * b;
  return t - b;
}
