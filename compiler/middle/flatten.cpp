#include "middle/flatten.h"

#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/Transforms/Utils/Local.h>
#include <llvm/Transforms/Utils/LoopUtils.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include "middle/directives_to_ir.h"
#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

/// Marks a loop that was two: as a directive of its own.
constexpr const char* kFlattened = "FLATTENED";

/// Iterations of one run of a loop, from its bounds or LOOP_TRIPCOUNT; most 0: not known.
struct Trips {
  uint64_t least = 0, most = 0;
};

Trips trips_of(const Loop& loop, ScalarEvolution& evolution) {
  if (uint64_t exact = evolution.getSmallConstantTripCount(&loop)) return {exact, exact};
  if (std::optional<Directive> told = loop_directive(loop, "LOOP_TRIPCOUNT"))
    return {static_cast<uint64_t>(told->integer("min", 0)), static_cast<uint64_t>(told->integer("max", 0))};
  return {0, evolution.getSmallConstantMaxTripCount(&loop)};
}

/// Makes one loop of two. The values that cross blocks go through memory while the control flow changes.
class Flattener {
 public:
  Flattener(Loop& inner, Function& function)
      : inner_(inner), outer_(*inner.getParentLoop()), function_(function), context_(function.getContext()) {}

  /// `trips` are those of the new loop.
  void run(Trips trips) {
    BasicBlock *inner_header = inner_.getHeader(), *inner_latch = inner_.getLoopLatch();
    BasicBlock *outer_header = outer_.getHeader(), *outer_latch = outer_.getLoopLatch();
    BasicBlock* entry = outer_.getLoopPreheader();
    MDNode* id = inner_.getLoopID();
    addresses_to_users();
    values_to_memory();
    slots_.push_back(
        new AllocaInst(Type::getInt1Ty(context_), 0, "first", function_.getEntryBlock().begin()));

    BasicBlock* header = make_block(inner_header->getName() + ".nest");
    IRBuilder<> builder(header);
    Value* first = builder.CreateLoad(builder.getInt1Ty(), slots_.back(), "first");
    builder.CreateCondBr(first, outer_header, inner_header);
    BasicBlock* latch = make_block(header->getName() + ".latch");
    BranchInst::Create(header, latch);
    lead(entry, outer_header, header, true);
    lead(outer_latch, outer_header, latch, true);
    lead(inner_latch, inner_header, latch, false);
    std::string told =
        "LOOP_TRIPCOUNT min=" + std::to_string(trips.least) + " max=" + std::to_string(trips.most);
    for (const std::string& directive : {told, std::string(kFlattened)})
      id = with_directive(id, parse_directive(directive), context_);
    latch->getTerminator()->setMetadata(LLVMContext::MD_loop, id);

    DominatorTree dominators(function_);
    PromoteMemToReg(slots_, dominators);
  }

 private:
  BasicBlock* make_block(const Twine& name) { return BasicBlock::Create(context_, name, &function_); }

  /// Turns the edge from `from` to `old_target` to `target`; the next iteration is a first one of the inner
  /// loop when `begins`.
  void lead(BasicBlock* from, BasicBlock* old_target, BasicBlock* target, bool begins) {
    BasicBlock* step = make_block(from->getName() + ".step");
    IRBuilder<> builder(step);
    builder.CreateStore(builder.getInt1(begins), slots_.back());
    builder.CreateBr(target);
    from->getTerminator()->replaceSuccessorWith(old_target, step);
  }

  bool crosses_blocks(const Instruction& instruction) const {
    return any_of(instruction.users(), [&](const User* user) {
      return isa<PHINode>(user) || cast<Instruction>(user)->getParent() != instruction.getParent();
    });
  }

  /// An address stays in the block of its access, which would otherwise choose between addresses.
  void addresses_to_users() {
    std::vector<Instruction*> work;
    for (BasicBlock* block : outer_.blocks())
      for (Instruction& instruction : *block)
        if (instruction.getType()->isPointerTy()) work.push_back(&instruction);
    // From the last to the first, so that what an address is made of follows it.
    while (!work.empty()) {
      Instruction* address = work.back();
      work.pop_back();
      for (Use& use : make_early_inc_range(address->uses())) {
        auto* user = cast<Instruction>(use.getUser());
        if (user->getParent() == address->getParent()) continue;
        Instruction* copy = address->clone();
        copy->insertBefore(user);
        use.set(copy);
        for (Value* operand : copy->operands())
          if (auto* base = dyn_cast<Instruction>(operand);
              base && base->getType()->isPointerTy() && outer_.contains(base))
            work.push_back(base);
      }
    }
  }

  void values_to_memory() {
    std::vector<PHINode*> phis;
    std::vector<Instruction*> others;
    for (BasicBlock* block : outer_.blocks())
      for (Instruction& instruction : *block)
        if (auto* phi = dyn_cast<PHINode>(&instruction))
          phis.push_back(phi);
        else if (crosses_blocks(instruction))
          others.push_back(&instruction);
    BasicBlock::iterator at = function_.getEntryBlock().begin();
    for (Instruction* other : others)
      if (AllocaInst* slot = DemoteRegToStack(*other, false, at)) slots_.push_back(slot);
    for (PHINode* phi : phis)
      if (AllocaInst* slot = DemotePHIToStack(phi, at)) slots_.push_back(slot);
  }

  Loop &inner_, &outer_;
  Function& function_;
  LLVMContext& context_;
  std::vector<AllocaInst*> slots_;
};

bool is_off(const Loop& loop) {
  std::optional<Directive> directive = loop_directive(loop, "LOOP_FLATTEN");
  return directive && directive->has("off");
}

bool asks(const Loop& loop) { return loop_directive(loop, "LOOP_FLATTEN") && !is_off(loop); }

/// An access, or a division, which the pipeline would then have in every iteration.
bool is_work(const Instruction& instruction) {
  if (instruction.isDebugOrPseudoInst() || instruction.isLifetimeStartOrEnd()) return false;
  return instruction.mayReadOrWriteMemory() || instruction.isIntDivRem();
}

bool calls_process(const Loop& loop) {
  for (BasicBlock* block : loop.blocks())
    for (Instruction& instruction : *block)
      if (auto* call = dyn_cast<CallInst>(&instruction))
        if (call->getCalledFunction() && !call->getCalledFunction()->isDeclaration()) return true;
  return false;
}

/// Whether a pointer comes from several places.
bool chooses_addresses(const Loop& loop) {
  for (BasicBlock* block : loop.blocks())
    for (Instruction& instruction : *block) {
      if (!instruction.getType()->isPointerTy()) continue;
      bool meets_others = any_of(instruction.users(), [](const User* user) { return isa<PHINode>(user); });
      if (isa<PHINode>(instruction) || meets_others) return true;
    }
  return false;
}

/// Why a pipelined loop and the one around it cannot be one loop; empty when they can.
std::string hindrance(const Loop& inner) {
  const Loop* outer = inner.getParentLoop();
  if (!outer) return "there is no loop around it";
  if (outer->getSubLoops().size() != 1) return "the loop around it holds other loops";
  if (!inner.isLoopSimplifyForm() || !outer->isLoopSimplifyForm()) return "its shape is irregular";
  if (calls_process(*outer)) return "it starts processes";
  if (chooses_addresses(*outer)) return "it chooses between arrays";
  return "";
}

bool is_wanted(const Loop& inner) {
  const Loop& outer = *inner.getParentLoop();
  if (is_off(inner) || is_off(outer)) return false;
  if (asks(inner) || asks(outer)) return true;
  if (!loop_directive(inner, "PIPELINE")) return false;
  for (BasicBlock* block : outer.blocks())
    if (!inner.contains(block) && any_of(*block, is_work)) return false;
  return true;
}

/// The innermost loop to flatten next, or null.
Loop* next_nest(LoopInfo& loops, const std::function<bool(const SourceLocation&)>& keeps_apart) {
  for (Loop* loop : loops.getLoopsInPreorder())
    if (is_pipelined(*loop) && hindrance(*loop).empty() && is_wanted(*loop) &&
        !keeps_apart(location_of(*loop)))
      return loop;
  return nullptr;
}

}  // namespace

bool is_pipelined(const Loop& loop) {
  std::optional<Directive> directive = loop_directive(loop, "PIPELINE");
  return loop.isInnermost() && !(directive && directive->has("off"));
}

SourceLocation location_of(const Loop& loop) {
  return loop.getStartLoc() ? location_of(loop.getStartLoc()) : nearest_location(loop.getHeader()->front());
}

std::vector<SourceLocation> flatten_loops(Function& function,
                                          const std::function<bool(const SourceLocation&)>& keeps_apart,
                                          Diagnostics& diagnostics) {
  TargetLibraryInfoImpl library_info{Triple(function.getParent()->getTargetTriple())};
  TargetLibraryInfo library(library_info);
  while (true) {
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    AssumptionCache assumptions(function);
    ScalarEvolution evolution(function, library, assumptions, dominators, loops);
    Loop* inner = next_nest(loops, keeps_apart);
    if (!inner) break;
    Trips in = trips_of(*inner, evolution), around = trips_of(*inner->getParentLoop(), evolution);
    Flattener(*inner, function).run({in.least * around.least, in.most * around.most});
  }
  std::vector<SourceLocation> flattened;
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  for (Loop* loop : loops.getLoopsInPreorder())
    if (loop_directive(*loop, kFlattened))
      flattened.push_back(location_of(*loop));
    else if (is_pipelined(*loop) && asks(*loop) && !hindrance(*loop).empty())
      diagnostics.warn(location_of(*loop), "the loop is not flattened: " + hindrance(*loop));
  return flattened;
}

}  // namespace hlsc
