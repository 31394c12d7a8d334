// ++, --, compound assignment and wrap.
// top: apint_increment
#include "ap_int.h"
ap_uint<4> apint_increment(ap_uint<4> a, ap_int<3> b) {
  a++;
  --a;
  a += b;
  a <<= 1;
  a ^= 5;
  return a--;
}
