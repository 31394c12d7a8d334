/// AGGREGATE: the members of an array of structs in one memory with one word an element.
#ifndef HLSC_DESIGN_AGGREGATE_H
#define HLSC_DESIGN_AGGREGATE_H

#include "design/design.h"
#include "frontend/diagnostic.h"

namespace hlsc {

/// Joins memories that are members of one aggregate (`Memory::aggregate`): loads of the members of an element
/// become slices of one load of its word, stores of all its members one store. A member that is not stored
/// with the others keeps what the block has loaded from that element before; outside of loops it is loaded
/// for that. Where neither holds the members stay apart, with a warning. After narrow(): a word has the bits that its members need.
void join_aggregates(Process& process, Diagnostics& diagnostics);

}  // namespace hlsc

#endif
