/// The middle of the compiler: from Clang's unoptimised IR to functions whose pipelined loops are single
/// blocks.
#ifndef HLSC_MIDDLE_PIPELINE_H
#define HLSC_MIDDLE_PIPELINE_H

#include <functional>
#include <string>
#include <vector>

#include "frontend/frontend.h"
#include "middle/directives_to_ir.h"

namespace hlsc {

struct MiddleResult {
  DirectiveTable directives;
  /// Mangled names of the functions that become modules; the top last.
  std::vector<std::string> processes;
  std::vector<SourceLocation> flattened;  ///< Loops that were several.
};

/// Chooses loops by the place where they begin.
using LoopChoice = std::function<bool(const SourceLocation&)>;

/// Inlines everything into the processes, optimises, unrolls as asked, flattens nests except those of
/// `keeps_apart` (flatten.h), and if-converts the innermost loops. `in_sequence`: DATAFLOW is left out.
MiddleResult run_middle(Program& program, const LoopChoice& keeps_apart, bool in_sequence,
                        Diagnostics& diagnostics);

/// Whether the program has streams beside those of parameters.
bool declares_streams_or_tasks(const llvm::Module& module);

}  // namespace hlsc

#endif
