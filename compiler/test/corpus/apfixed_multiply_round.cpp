// Fixed-point product rounded and saturated.
// top: apfixed_multiply_round
#include "ap_fixed.h"
ap_fixed<10, 4, AP_RND, AP_SAT> apfixed_multiply_round(ap_fixed<12, 5> a, ap_fixed<9, 3> b) { return a * b; }
