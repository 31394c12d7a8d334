/// Loads of the same word are one access, and none after a store of it.
#ifndef HLSC_DESIGN_SHARE_LOADS_H
#define HLSC_DESIGN_SHARE_LOADS_H

#include "design/design.h"

namespace hlsc {

/// Where a memory with ports is read twice at one address in a block and not written in between, the second
/// use takes the first one's word. The branches of an if often read what the code behind it reads again; LLVM
/// keeps those apart, as it must not read where the program does not. A word that the block has just stored is
/// not read at all: a line buffer that shifts a column and then looks at it needs one read port.
void share_loads(Process& process);

}  // namespace hlsc

#endif
