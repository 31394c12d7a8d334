/// LOOP_FLATTEN: a loop around a pipelined loop becomes one loop with it, so that the pipeline fills once and not
/// in every iteration of the outer loop.
#ifndef HLSC_MIDDLE_FLATTEN_H
#define HLSC_MIDDLE_FLATTEN_H

#include <functional>
#include <vector>

#include "frontend/diagnostic.h"

namespace llvm {
class Function;
class Loop;
}  // namespace llvm

namespace hlsc {

/// Flattens the nests of `function` from the inside out: a pipelined loop and the loop around it, where either
/// has LOOP_FLATTEN, or the inner one PIPELINE and the outer one no accesses to arrays and streams of its own.
/// `LOOP_FLATTEN off` at either keeps them apart, and so does `keeps_apart` of the inner loop's place. Warns
/// where LOOP_FLATTEN cannot be followed. Returns the places of the loops it has made.
std::vector<SourceLocation> flatten_loops(llvm::Function& function,
                                          const std::function<bool(const SourceLocation&)>& keeps_apart,
                                          Diagnostics& diagnostics);

/// Where a loop begins in the source.
SourceLocation location_of(const llvm::Loop& loop);

/// Whether an innermost loop runs as a pipeline: all but those with `PIPELINE off`.
bool is_pipelined(const llvm::Loop& loop);

}  // namespace hlsc

#endif
