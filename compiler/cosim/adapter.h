/// Generates the C++ that stands in for the top function in a test bench and runs the Verilator model
/// instead.
#ifndef HLSC_COSIM_ADAPTER_H
#define HLSC_COSIM_ADAPTER_H

#include <string>

#include "tool/compile.h"

namespace hlsc {

/// The adapter's text. It includes the design's sources under another name of the top, for their types, and
/// defines the top itself. `model` is the Verilator class (V + module name).
std::string adapter_text(const CompileResult& compiled, const CompileOptions& options,
                         const std::string& model);

}  // namespace hlsc

#endif
