/// Counters of loops that do not run at the same time share registers.
#ifndef HLSC_DESIGN_SHARED_PHIS_H
#define HLSC_DESIGN_SHARED_PHIS_H

#include <map>

#include "design/design.h"

namespace hlsc {

/// By phi of a pipelined loop: the phi of an earlier one whose register it uses. One loop of a process has
/// ended before the next begins, and every register begins anew. Only phis that step alike share, as others
/// would take a multiplexer for it.
std::map<ValueId, ValueId> shared_phis(const Process& process);

}  // namespace hlsc

#endif
