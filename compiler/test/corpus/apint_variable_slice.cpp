// A bit and a range at a run-time position.
// top: apint_variable_slice
// range: i=0..24
#include "ap_int.h"
ap_uint<8> apint_variable_slice(ap_uint<32> a, ap_uint<5> i) {
  ap_uint<8> r = a.range(i + 7, i);
  r[0] = a[i];
  return r;
}
