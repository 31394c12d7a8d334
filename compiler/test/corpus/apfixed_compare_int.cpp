// Fixed point against integers, conversion to integer.
// top: apfixed_compare_int
#include "ap_fixed.h"
int apfixed_compare_int(ap_fixed<11, 6> a) { return a > 3 ? a.to_int() : (a < -2 ? -a.to_int() : 100); }
