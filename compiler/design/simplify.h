/// Removes operations that only pass a value on.
#ifndef HLSC_DESIGN_SIMPLIFY_H
#define HLSC_DESIGN_SIMPLIFY_H

#include "design/design.h"

namespace hlsc {

/// Replaces uses of casts that keep the representation, and of phis with one distinct operand, by their
/// operand. Run after narrow().
void forward_copies(Process& process);

}  // namespace hlsc

#endif
