/// Clang passes and returns small structs as one or two integers: stores and loads that cover several
/// members.
#ifndef HLSC_MIDDLE_SPLIT_ACCESSES_H
#define HLSC_MIDDLE_SPLIT_ACCESSES_H

namespace llvm {
class Function;
}

namespace hlsc {

/// Makes an access of an integer that covers whole members or elements of an object an access of each of
/// them.
void split_wide_accesses(llvm::Function& function);

}  // namespace hlsc

#endif
