/// A `#pragma HLS` (or a directive of a project file) as a value: kind and options.
#ifndef HLSC_FRONTEND_DIRECTIVE_H
#define HLSC_FRONTEND_DIRECTIVE_H

#include <map>
#include <string>

namespace hlsc {

/// One directive, `KIND key=value flag`. Kind is in upper case, keys in lower case; a flag has an empty
/// value.
struct Directive {
  std::string kind;
  std::map<std::string, std::string> options;

  bool has(const std::string& key) const { return options.count(key) != 0; }
  /// Text of an option, or `otherwise` when it is not given.
  std::string text(const std::string& key, const std::string& otherwise = "") const;
  /// Integer of an option; throws std::invalid_argument when it is no integer.
  long integer(const std::string& key, long otherwise) const;
};

/// Parses `KIND key=value flag ...`; case of kind and keys does not matter.
Directive parse_directive(const std::string& text);

/// The inverse of parse_directive.
std::string to_text(const Directive& directive);

}  // namespace hlsc

#endif
