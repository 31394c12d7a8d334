/// Accesses that never happen together share one port.
#ifndef HLSC_DESIGN_EXCLUSIVE_H
#define HLSC_DESIGN_EXCLUSIVE_H

#include "design/design.h"

namespace hlsc {

/// Merges neighbouring accesses of one kind to one stream (or stores to one memory with ports) whose
/// predicates exclude each other, as the branches of an if do: the access happens when one of them does, with
/// the data of that one.
void merge_exclusive_accesses(Process& process);

}  // namespace hlsc

#endif
