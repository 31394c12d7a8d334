/// Products too wide for one multiplier block.
#ifndef HLSC_DESIGN_SPLIT_PRODUCTS_H
#define HLSC_DESIGN_SPLIT_PRODUCTS_H

#include "design/design.h"

namespace hlsc {

/// Turns a product with a factor of more than `block_bits` bits, sign included, into a sum of products that
/// each fit a block: a * b = (high * b << n) + low * b with a = high * 2^n + low and n = block_bits - 1, the
/// most bits of a low part that also fits beside a signed factor. The schedule can then have a register
/// between block and sum. For FPGAs whose blocks do not add each other's products.
void split_products(Process& process, unsigned block_bits);

}  // namespace hlsc

#endif
