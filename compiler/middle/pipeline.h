/// The middle of the compiler: from Clang's unoptimised IR to functions whose pipelined loops are single
/// blocks.
#ifndef HLSC_MIDDLE_PIPELINE_H
#define HLSC_MIDDLE_PIPELINE_H

#include <string>
#include <vector>

#include "frontend/frontend.h"
#include "middle/directives_to_ir.h"

namespace hlsc {

struct MiddleResult {
  DirectiveTable directives;
  /// Mangled names of the functions that become modules; the top last.
  std::vector<std::string> processes;
};

/// Inlines everything into the processes, optimises, unrolls as asked, and if-converts the innermost loops.
MiddleResult run_middle(Program& program, Diagnostics& diagnostics);

}  // namespace hlsc

#endif
