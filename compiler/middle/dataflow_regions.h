/// Brings DATAFLOW functions into the form of a region: calls in a row, each with objects of its own.
#ifndef HLSC_MIDDLE_DATAFLOW_REGIONS_H
#define HLSC_MIDDLE_DATAFLOW_REGIONS_H

#include "frontend/frontend.h"

namespace llvm {
class Function;
}

namespace hlsc {

/// Gives each iteration of an unrolled loop its own locals, and each row of an array of arrays that is only
/// used row by row an object of its own, with the directives of the whole. Runs before inlining, after the
/// region's loops are unrolled.
void separate_region_objects(const Program& program, llvm::Function& region);

}  // namespace hlsc

#endif
