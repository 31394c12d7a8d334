// Convergent rounding, symmetric saturation.
// top: apfixed_convergent
#include "ap_fixed.h"
ap_fixed<7, 3, AP_RND_CONV, AP_SAT_SYM> apfixed_convergent(ap_fixed<14, 5> a) { return a; }
