/// Expands memcpy, memmove and memset into typed loads and stores, so that each access is one element of one
/// memory.
#ifndef HLSC_MIDDLE_MEMORY_COPIES_H
#define HLSC_MIDDLE_MEMORY_COPIES_H

namespace llvm {
class Module;
}

namespace hlsc {

/// Small copies are unrolled member by member, large arrays become loops. Throws CompileError for sizes
/// unknown at compile time.
void expand_memory_copies(llvm::Module& module);

}  // namespace hlsc

#endif
