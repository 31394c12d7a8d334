/// Operations without a use that shows outside.
#ifndef HLSC_DESIGN_DEAD_H
#define HLSC_DESIGN_DEAD_H

#include "design/design.h"

namespace hlsc {

/// Takes operations out of their blocks that no stream, port or branch depends on. A memory whose words are
/// only copied within it, as the padding of structs is, goes with its accesses; one without
/// accesses is neither read nor written.
void remove_dead(Process& process);

}  // namespace hlsc

#endif
