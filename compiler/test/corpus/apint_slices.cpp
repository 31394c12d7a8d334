// range() read and written, bit read and written.
// top: apint_slices
#include "ap_int.h"
ap_uint<24> apint_slices(ap_uint<24> a) {
  ap_uint<24> r = a;
  r.range(7, 0) = a.range(23, 16);
  r.range(23, 16) = a.range(7, 0);
  r[8] = a[15];
  return r;
}
