/// Accesses that never happen together: they share one port, and need no order.
#ifndef HLSC_DESIGN_EXCLUSIVE_H
#define HLSC_DESIGN_EXCLUSIVE_H

#include "design/design.h"

namespace hlsc {

/// Merges neighbouring accesses of one kind to one stream (or stores to one memory with ports) whose
/// predicates exclude each other, as the branches of an if do: the access happens when one of them does, with
/// the data of that one.
void merge_exclusive_accesses(Process& process);

/// Whether two accesses to one memory in the same block touch different words of an iteration because a
/// predicate of theirs says so: `if (a != b) { x[a] = ...; ... x[b] }`.
bool are_set_apart(const Process& process, const Operation& a, const Operation& b);

}  // namespace hlsc

#endif
