/// Bit-width narrowing: every operation computes and keeps only the bits that carry information and that
/// somebody uses.
#ifndef HLSC_DESIGN_NARROW_H
#define HLSC_DESIGN_NARROW_H

#include "design/design.h"

namespace hlsc {

/// Shrinks `bits` of operations and `width` of memories, from operands to results (ranges) and from uses to
/// definitions (demanded bits), and removes operations whose result nobody uses. Values of used bits do not
/// change.
void narrow(Process& process);

}  // namespace hlsc

#endif
