/// The comments of a case that steer its run and state what is expected of it
/// (compiler/test/corpus/README.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hlsc::differential {

/// A comment that states something, and the line it stands on.
struct Statement {
  std::string text;
  unsigned line = 0;
};

struct Steering {
  struct Range {
    long long low, high;
  };
  std::string top;
  int calls = 8;
  int tokens = 256;                      ///< Offered to each input stream in a call.
  std::vector<std::string> files;        ///< Further source files, beside the case.
  std::map<std::string, Range> ranges;   ///< By parameter: bounds of its values, for arrays of each element.
  std::map<std::string, long> elements;  ///< By parameter: elements behind a pointer.
  std::vector<Statement> expectations;   ///< `// expect:`
  std::vector<Statement> errors;         ///< `// error:`
  std::vector<Statement> warnings;       ///< `// warning:`
};

/// Reads the comments of `kernel`; expectations may stand behind code, all others on lines of their own.
/// Throws std::runtime_error when the file cannot be read or a line cannot be understood.
Steering read_steering(const std::filesystem::path& kernel);

std::string read_text(const std::filesystem::path& path);

}  // namespace hlsc::differential
