/// Loads of the same word are one access.
#ifndef HLSC_DESIGN_SHARE_LOADS_H
#define HLSC_DESIGN_SHARE_LOADS_H

#include "design/design.h"

namespace hlsc {

/// Where a memory with ports is read twice at one address in a block and not written in between, the second
/// use takes the first one's word. The branches of an if often read what the code behind it reads again; LLVM
/// keeps those apart, as it must not read where the program does not.
void share_loads(Process& process);

}  // namespace hlsc

#endif
