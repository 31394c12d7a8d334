/// LLVM IR to the compiler's own form: one function to one Process.
#ifndef HLSC_DESIGN_BUILD_H
#define HLSC_DESIGN_BUILD_H

#include "design/design.h"
#include "frontend/frontend.h"
#include "middle/pipeline.h"

namespace hlsc {

/// Builds the process of the function with mangled name `function`. Throws CompileError with a source line
/// for what has no hardware form (unknown pointers, calls that are not inlined, floating point).
Process build_process(const Program& program, const MiddleResult& middle, const std::string& function,
                      const std::string& module_name);

/// Builds the dataflow region of the top, whose calls lead to `processes` (in the order of
/// MiddleResult::processes, without the top).
Region build_region(const Program& program, const MiddleResult& middle,
                    const std::vector<Process>& processes);

}  // namespace hlsc

#endif
