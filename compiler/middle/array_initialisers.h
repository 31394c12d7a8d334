/// The types of arrays whose last elements are zero.
#ifndef HLSC_MIDDLE_ARRAY_INITIALISERS_H
#define HLSC_MIDDLE_ARRAY_INITIALISERS_H

namespace llvm {
class Module;
}

namespace hlsc {

/// Clang writes `static const int t[256] = {3, 1}` as a packed struct of two integers and an array of 254 zeros:
/// such globals, and structs that hold such arrays, get the types with which they are declared. Runs after
/// inlining, when the program's subscripts tell them.
void restore_array_types(llvm::Module& module);

}  // namespace hlsc

#endif
