/// Verilog identifiers from the names of the source.
#ifndef HLSC_DESIGN_NAMES_H
#define HLSC_DESIGN_NAMES_H

#include <map>
#include <string>

namespace hlsc {

/// Hands out unique Verilog identifiers, deterministic in the order of requests.
class NameTable {
 public:
  NameTable();
  /// `wanted` made an identifier; a number is appended when it is taken. Empty: `otherwise`.
  std::string unique(const std::string& wanted, const std::string& otherwise = "value");

 private:
  std::map<std::string, int> used_;
};

/// Whether Verilog or SystemVerilog keeps the word for itself.
bool is_keyword(const std::string& word);

/// The variable part of an LLVM value name: `at.i.sroa.0.1` -> `at`.
std::string variable_part(const std::string& llvm_name);

}  // namespace hlsc

#endif
