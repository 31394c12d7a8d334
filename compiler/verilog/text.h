/// Small pieces of Verilog text.
#ifndef HLSC_VERILOG_TEXT_H
#define HLSC_VERILOG_TEXT_H

#include <llvm/ADT/APInt.h>

#include <string>

namespace hlsc {

/// ` [w-1:0]`, or nothing for one bit.
std::string range_text(unsigned width);

/// A sized literal with the low `width` bits of `value`, sign-extended when it is narrower.
std::string literal_text(const llvm::APInt& value, unsigned width);

/// `name`, which is `bits` wide, extended or cut to `width` bits.
std::string resized_text(const std::string& name, unsigned bits, bool is_signed, unsigned width);

}  // namespace hlsc

#endif
