/// Calls that serve the C simulation only: assertions and printing.
#ifndef HLSC_MIDDLE_HOST_CALLS_H
#define HLSC_MIDDLE_HOST_CALLS_H

#include "frontend/diagnostic.h"

namespace llvm {
class Module;
}

namespace hlsc {

/// A failing assert() becomes a path that is never taken, so that what it states narrows the values. printf
/// and its like and std::cout are left out with a warning. Runs on unoptimised IR.
void remove_host_calls(llvm::Module& module, Diagnostics& diagnostics);

}  // namespace hlsc

#endif
