/// One case from C++ to a verdict: compile, run natively, run the Verilog on the same arguments, compare.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hlsc::differential {

enum class Outcome {
  kPass,
  kRefused,      ///< The compiler refuses the program with a message.
  kMismatch,     ///< A result differs from C++.
  kDeadlock,     ///< The Verilog stands still.
  kExpectation,  ///< An `// expect:` line does not hold.
  kVerilog,      ///< Icarus refuses the Verilog.
  kNative,       ///< The native program does not compile or run: the case itself is wrong.
  kCrash,
  kHang,
};

const char* name_of(Outcome outcome);

struct CaseResult {
  Outcome outcome = Outcome::kPass;
  std::string detail;  ///< One line.
};

/// Runs `kernel` in the existing directory `work`, which keeps all files. `seed` decides arguments and
/// pauses.
CaseResult run_case(const std::filesystem::path& kernel, const std::filesystem::path& work,
                    std::uint64_t seed);

}  // namespace hlsc::differential
