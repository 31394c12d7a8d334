// / and % of negative ap_ints at odd widths.
// top: expr_odd_width_divide
// expect: operators divide=0 remainder=0
#include "ap_int.h"
ap_int<14> expr_odd_width_divide(ap_int<13> a, ap_int<7> b) {
  if (b == 0) return -1;
  return a / b + a % b;
}
