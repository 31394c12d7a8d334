/// Random HLS programs for differential fuzzing: one kernel a seed, with the header comments of
/// compiler/test/corpus.
///
/// The programs have no undefined behaviour once compiled with -fwrapv: divisors are never zero, shift
/// amounts stay below the width, array indices are masked, every variable is initialised, and streams carry
/// as many tokens as are read.
#pragma once

#include <cstdint>
#include <string>

namespace hlsc::differential {

/// The text of the program of this seed; the top is called `fuzz_top`. The same seed gives the same text.
std::string generate_program(std::uint64_t seed);

}  // namespace hlsc::differential
