#include "verilog/text.h"

#include <llvm/ADT/StringExtras.h>

namespace hlsc {

std::string range_text(unsigned width) { return width == 1 ? "" : " [" + std::to_string(width - 1) + ":0]"; }

std::string literal_text(const llvm::APInt& value, unsigned width) {
  llvm::APInt cut = value.sextOrTrunc(width);
  bool is_small = cut.getActiveBits() <= 31;
  return std::to_string(width) +
         (is_small ? "'d" + llvm::toString(cut, 10, false) : "'h" + llvm::toString(cut, 16, false));
}

std::string resized_text(const std::string& name, unsigned bits, bool is_signed, unsigned width) {
  if (bits == width) return name;
  if (bits > width) return name + (width == 1 ? "[0]" : "[" + std::to_string(width - 1) + ":0]");
  std::string count = std::to_string(width - bits);
  if (!is_signed) return "{" + count + "'d0, " + name + "}";
  std::string sign = bits == 1 ? name : name + "[" + std::to_string(bits - 1) + "]";
  return "{{" + count + "{" + sign + "}}, " + name + "}";
}

}  // namespace hlsc
