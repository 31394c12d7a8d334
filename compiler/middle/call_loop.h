/// Overlapping calls: a function with PIPELINE becomes an endless loop whose iterations are its calls.
#ifndef HLSC_MIDDLE_CALL_LOOP_H
#define HLSC_MIDDLE_CALL_LOOP_H

#include <string>

#include "frontend/frontend.h"

namespace llvm {
class Function;
}  // namespace llvm

namespace hlsc {

/// Makes `function`, a process that asks for PIPELINE, a loop of its calls; static scalars become values that
/// one call hands to the next. Says why when the calls cannot overlap (a loop is left in the body, or
/// `in_region` others wait for the end of its runs); the function is as it was then. Runs when all loops have
/// dissolved that will.
std::string make_call_loop(const FunctionInfo& info, llvm::Function& function, bool in_region);

/// Whether the loop of the function is one of its calls.
bool is_call_loop(const llvm::Function& function);

}  // namespace hlsc

#endif
