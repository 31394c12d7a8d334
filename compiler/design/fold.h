/// Operations that change nothing become plain wires, so that the schedule counts no delay for them.
#ifndef HLSC_DESIGN_FOLD_H
#define HLSC_DESIGN_FOLD_H

#include "design/design.h"

namespace hlsc {

/// Turns into truncations: `x & constant` where the constant has ones wherever x may have them, and `x != 0`,
/// `x == 1` of a single bit. After narrow(): every result keeps its bits.
void fold(Process& process);

}  // namespace hlsc

#endif
