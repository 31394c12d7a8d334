// Addition far beyond 64 bits.
// top: apint_wide_add
#include "ap_int.h"
ap_uint<101> apint_wide_add(ap_uint<100> a, ap_uint<97> b) { return a + b; }
