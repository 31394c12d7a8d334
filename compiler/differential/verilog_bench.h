/// The Verilog half of a case: a test bench that plays the words recorded by the native program into the
/// compiled top and compares all that comes out, with random pauses on every stream.
#pragma once

#include <cstdint>
#include <string>

#include "differential/steering.h"
#include "tool/compile.h"

namespace hlsc::differential {

/// Token counts of a recorded stream decide the size of its memory in the bench.
struct RecordedSizes {
  std::vector<std::size_t> streams;  ///< Words by index in TopInterface::streams.
};

/// The bench, Verilog-2005. It reads the native program's files from the working directory and prints `PASS`
/// and the number of cycles, or `FAIL` with the port, the call and both words. `seed` 0: no pauses. With an
/// odd seed, a top that has only streams and scalar inputs is started again as soon as it is ready, so that
/// its runs overlap.
std::string verilog_bench(const CompileResult& compiled, const Steering& steering, const RecordedSizes& sizes,
                          std::uint64_t seed);

}  // namespace hlsc::differential
