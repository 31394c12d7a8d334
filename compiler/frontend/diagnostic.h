/// Errors and warnings of the compiler: one sentence at file:line:column that says what to do.
#ifndef HLSC_FRONTEND_DIAGNOSTIC_H
#define HLSC_FRONTEND_DIAGNOSTIC_H

#include <stdexcept>
#include <string>
#include <vector>

namespace hlsc {

/// A place in the user's source. `line` 0 means unknown.
struct SourceLocation {
  std::string file;
  unsigned line = 0;
  unsigned column = 0;

  std::string text() const {
    if (line == 0) return file.empty() ? "<unknown>" : file;
    return file + ":" + std::to_string(line) + (column ? ":" + std::to_string(column) : "");
  }
};

/// A program that cannot be compiled; what() is `file:line:column: error: sentence`.
class CompileError : public std::runtime_error {
 public:
  CompileError(const SourceLocation& where, const std::string& sentence)
      : std::runtime_error(where.text() + ": error: " + sentence), where_(where), sentence_(sentence) {}
  /// `sentence` may be Clang's own text, which says where.
  explicit CompileError(const std::string& sentence)
      : std::runtime_error(sentence.find("error: ") == std::string::npos ? "error: " + sentence : sentence),
        sentence_(sentence) {}

  const SourceLocation& where() const { return where_; }  ///< Line 0: nobody told.
  const std::string& sentence() const { return sentence_; }

 private:
  SourceLocation where_;
  std::string sentence_;
};

/// A DATAFLOW function whose calls cannot be processes.
class RegionError : public CompileError {
 public:
  explicit RegionError(const CompileError& reason) : CompileError(reason) {}
};

/// A warning where none is accepted: its text as it is.
class StrictWarning : public std::runtime_error {
 public:
  explicit StrictWarning(const std::string& warning) : std::runtime_error(warning) {}
};

/// Warnings gathered while compiling, in source order of discovery.
struct Diagnostics {
  std::vector<std::string> warnings;

  void warn(const SourceLocation& where, const std::string& sentence) {
    std::string text = where.text() + ": warning: " + sentence;
    for (const std::string& known : warnings)
      if (known == text) return;
    warnings.push_back(text);
  }
};

}  // namespace hlsc

#endif
