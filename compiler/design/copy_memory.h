/// A second read port of a memory: a copy of it that is written alike.
#ifndef HLSC_DESIGN_COPY_MEMORY_H
#define HLSC_DESIGN_COPY_MEMORY_H

#include "design/design.h"

namespace hlsc {

/// Whether the memory can have a copy, or one more: it is a RAM or ROM of the process alone, read in more than
/// one place of a block, and small or not copied yet.
bool can_copy_memory(const Process& process, int memory);

/// Gives `memory` a copy; every second load of a block reads it.
void copy_memory(Process& process, int memory);

}  // namespace hlsc

#endif
