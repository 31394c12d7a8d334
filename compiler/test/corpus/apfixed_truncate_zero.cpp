// Truncation to zero and wrap.
// top: apfixed_truncate_zero
#include "ap_fixed.h"
ap_fixed<8, 2, AP_TRN_ZERO, AP_WRAP> apfixed_truncate_zero(ap_fixed<13, 5> a, ap_ufixed<6, 2> b) { return a - b; }
