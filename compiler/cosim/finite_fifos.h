/// C simulation with the declared FIFO depths: makes the calls in DATAFLOW functions processes that run side
/// by side (finite/processes.h).
#ifndef HLSC_COSIM_FINITE_FIFOS_H
#define HLSC_COSIM_FINITE_FIFOS_H

#include <string>

#include "frontend/frontend.h"

namespace hlsc {

/// LLVM IR, as text, of a program that was parsed for simulation: each call in a DATAFLOW function starts a
/// process, streams between them have their depths, and every access to a stream tells its place in the
/// source.
std::string finite_fifo_program(Program& program);

}  // namespace hlsc

#endif
