/// Division without a divider: what the scheduler can pipeline.
#ifndef HLSC_DESIGN_DIVIDE_H
#define HLSC_DESIGN_DIVIDE_H

#include "design/design.h"

namespace hlsc {

/// Replaces every quotient and remainder. By a constant: a multiplication with the rounded-up reciprocal 2^(n
/// + l) / d, l = ceil(log2 d), which is exact for dividends of n bits (Granlund and Montgomery, PLDI 1994,
/// theorem 4.2). By a variable: restoring division, a subtraction per bit of the quotient. Signed division
/// works on magnitudes. A quotient by 0 is all ones, as no program may rely on it. Run after narrow().
void expand_divisions(Process& process);

}  // namespace hlsc

#endif
