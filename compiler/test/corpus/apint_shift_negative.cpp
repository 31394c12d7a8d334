// Arithmetic shift right of a negative odd-width value by a run-time amount.
// top: apint_shift_negative
#include "ap_int.h"
ap_int<19> apint_shift_negative(ap_int<19> a, ap_uint<5> s) { return (a >> s) + (a << 2); }
