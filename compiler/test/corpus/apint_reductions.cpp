// and/or/xor reductions.
// top: apint_reductions
#include "ap_int.h"
ap_uint<3> apint_reductions(ap_uint<17> a) {
  ap_uint<3> r;
  r[0] = a.and_reduce();
  r[1] = a.or_reduce();
  r[2] = a.xor_reduce();
  return r;
}
