/// Compiling a case alone: what the compiler says, in a child process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "differential/run_case.h"

namespace hlsc::differential {

/// Outcome kPass, kRefused, kCrash or kHang, and what was said: the error, or one warning a line. Messages
/// begin with `LINE:COLUMN: `, without file name and the words error and warning.
struct CompileCheck {
  Outcome outcome = Outcome::kPass;
  std::string messages;
};

/// Compiles `kernel`; the Verilog goes to `work`, which exists. With `strict`, a warning is an error.
CompileCheck compile_case(const std::filesystem::path& kernel, const std::filesystem::path& work,
                          bool strict);

/// Checks the `// error:` lines of a case that must be refused, or the `// warning:` lines of one that must
/// be compiled with them and, strictly, refused with the first. Any other outcome is kExpectation with what
/// was said instead.
CaseResult check_messages(const std::filesystem::path& kernel, const std::filesystem::path& work);

}  // namespace hlsc::differential
