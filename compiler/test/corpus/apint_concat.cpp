// Concatenation as value and as target.
// top: apint_concat
#include "ap_int.h"
ap_uint<16> apint_concat(ap_uint<8> a, ap_uint<8> b) {
  ap_uint<4> high, low;
  (high, low) = ap_uint<8>(a + b);
  return (low, high, a);
}
