/// C/RTL co-simulation: the user's test bench with the top's call replaced by the Verilator model.
#ifndef HLSC_COSIM_COSIM_H
#define HLSC_COSIM_COSIM_H

#include <string>
#include <vector>

#include "tool/compile.h"

namespace hlsc {

struct CosimOptions {
  std::vector<std::string> test_benches;  ///< C++ or C files, one with main().
  std::vector<std::string> flags;         ///< Of the test benches' compiler.
  std::string run_dir = ".";              ///< Where the test bench runs and finds its data.
  std::string work_dir;  ///< For generated and compiled files; empty: a temporary directory that is removed.
  unsigned long stall = 0;  ///< Seed of random stalls on all streams; 0: none.
  std::string trace;        ///< VCD file; empty: none.
};

/// Builds and runs the simulation; returns the test bench's exit code. Throws CompileError when it cannot be
/// built.
int cosimulate(const CompileResult& compiled, const CompileOptions& options, const CosimOptions& cosim);

}  // namespace hlsc

#endif
