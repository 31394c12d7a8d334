/// Expands memcpy, memmove and memset into typed loads and stores, so that each access is one element of one
/// memory.
#ifndef HLSC_MIDDLE_MEMORY_COPIES_H
#define HLSC_MIDDLE_MEMORY_COPIES_H

#include "frontend/frontend.h"

namespace llvm {
class Module;
}

namespace hlsc {

/// Small copies are unrolled member by member, large arrays become loops. Runs on unoptimised IR; a copy
/// whose memory or size shows only after inlining is left to expand_remaining_copies.
void expand_memory_copies(llvm::Module& module);

/// Throws CompileError for memory of unknown type and for sizes unknown at compile time.
void expand_remaining_copies(const Program& program);

}  // namespace hlsc

#endif
