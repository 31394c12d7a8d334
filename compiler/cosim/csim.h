/// C simulation: the user's test bench and design as a native program.
#ifndef HLSC_COSIM_CSIM_H
#define HLSC_COSIM_CSIM_H

#include "cosim/cosim.h"

namespace hlsc {

/// Builds and runs the program; returns the test bench's exit code. With `finite_fifos` streams between the
/// processes of DATAFLOW functions hold as many elements as declared, and processes run side by side: a
/// standstill is told, with the depths that would do, and ends with 3. Throws CompileError when the program
/// cannot be built.
int simulate_in_c(const CompileOptions& options, const CosimOptions& run, bool finite_fifos);

}  // namespace hlsc

#endif
