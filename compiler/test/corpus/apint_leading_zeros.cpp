// Leading-zero count by an unrolled loop.
// top: apint_leading_zeros
#include "ap_int.h"
ap_uint<5> apint_leading_zeros(ap_uint<16> a) {
  ap_uint<5> n = 16;
COUNT:
  for (int i = 0; i < 16; ++i) {
#pragma HLS UNROLL
    if (a[i]) n = 15 - i;
  }
  return n;
}
