/// Turns the body of an innermost loop into one block of predicated operations, the form the modulo scheduler
/// takes.
#ifndef HLSC_MIDDLE_IF_CONVERT_H
#define HLSC_MIDDLE_IF_CONVERT_H

namespace llvm {
class DominatorTree;
class Loop;
class LoopInfo;
}  // namespace llvm

namespace hlsc {

/// Flattens `loop` (innermost, in loop-simplify and LCSSA form, accesses as primitives). Phis become selects,
/// accesses to memory and streams take the predicate of their block, divisors of skipped divisions become 1.
/// A loop with several exits gets one exit condition and a dispatch behind the loop. Invalidates the given
/// analyses.
void if_convert(llvm::Loop& loop, llvm::LoopInfo& loops, llvm::DominatorTree& dominators);

}  // namespace hlsc

#endif
