/// Products with constants that one adder can make.
#ifndef HLSC_DESIGN_CONSTANT_MULTIPLY_H
#define HLSC_DESIGN_CONSTANT_MULTIPLY_H

#include "design/design.h"

namespace hlsc {

/// Turns x * (2^a + 2^b) and x * (2^a - 2^b) into an addition or subtraction of shifted x. Constants with
/// more digits stay products: a multiplier block costs less than a chain of adders.
void expand_constant_products(Process& process);

}  // namespace hlsc

#endif
