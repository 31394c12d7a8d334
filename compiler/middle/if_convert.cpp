#include "middle/if_convert.h"

#include <llvm/Analysis/LoopIterator.h>

#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

class IfConverter {
 public:
  IfConverter(Loop& loop, LoopInfo& loops, DominatorTree& dominators)
      : loop_(loop), loops_(loops), dominators_(dominators), builder_(loop.getHeader()->getContext()) {}

  void run() {
    if (loop_.getNumBlocks() == 1 && loop_.getExitingBlock()) return;
    header_ = loop_.getHeader();
    latch_ = loop_.getLoopLatch();
    MDNode* loop_id = loop_.getLoopID();
    order_blocks();
    collect_exits();

    merged_ = BasicBlock::Create(header_->getContext(), header_->getName() + ".flat", header_->getParent(),
                                 header_);
    builder_.SetInsertPoint(merged_);
    for (BasicBlock* block : order_) convert(*block);
    Value* leave = exit_condition();
    retarget_header_phis();
    MDNode* id = loop_id;
    finish(leave, id);
    for (BasicBlock* block : order_) block->dropAllReferences();
    for (BasicBlock* block : order_) block->eraseFromParent();
  }

 private:
  struct Exit {
    BasicBlock* from;
    BasicBlock* to;
    Value* taken = nullptr;  ///< Predicate of the edge.
  };

  void order_blocks() {
    LoopBlocksRPO order(&loop_);
    order.perform(&loops_);
    order_.assign(order.begin(), order.end());
  }

  void collect_exits() {
    for (BasicBlock* block : order_)
      for (BasicBlock* successor : successors(block))
        if (!loop_.contains(successor)) {
          bool known =
              any_of(exits_, [&](const Exit& exit) { return exit.from == block && exit.to == successor; });
          if (!known) exits_.push_back({block, successor});
        }
  }

  /// Predicate under which control goes from `from` to `to`.
  Value* edge(BasicBlock* from, BasicBlock* to) {
    auto& known = edges_[{from, to}];
    if (known) return known;
    Value* condition = nullptr;
    Instruction* terminator = from->getTerminator();
    if (auto* branch = dyn_cast<BranchInst>(terminator);
        branch && branch->isConditional() && branch->getSuccessor(0) != branch->getSuccessor(1)) {
      condition = branch->getCondition();
      if (branch->getSuccessor(1) == to) condition = builder_.CreateNot(condition);
    } else if (auto* choice = dyn_cast<SwitchInst>(terminator)) {
      condition = switch_condition(*choice, to);
    }
    return known = both(predicates_[from], condition);
  }

  Value* switch_condition(SwitchInst& choice, BasicBlock* to) {
    auto matches = [&](BasicBlock* target, bool same) {
      Value* any = builder_.getFalse();
      for (auto& one : choice.cases())
        if ((one.getCaseSuccessor() == target) == same)
          any = builder_.CreateOr(any, builder_.CreateICmpEQ(choice.getCondition(), one.getCaseValue()));
      return any;
    };
    if (choice.getDefaultDest() == to) return builder_.CreateNot(matches(to, false));
    return matches(to, true);
  }

  /// `first && second`; null stands for true in `second`.
  Value* both(Value* first, Value* second) {
    if (!second) return first;
    if (auto* constant = dyn_cast<ConstantInt>(first)) return constant->isOne() ? second : first;
    return builder_.CreateLogicalAnd(first, second);
  }

  /// True when every path of one iteration from `start` leads through `block`.
  bool always_follows(BasicBlock& block, BasicBlock& start) {
    SmallVector<BasicBlock*, 8> work = {&start};
    SmallPtrSet<BasicBlock*, 8> seen = {&start};
    while (!work.empty()) {
      BasicBlock* at = work.pop_back_val();
      for (BasicBlock* successor : successors(at)) {
        if (successor == &block) continue;
        if (successor == header_ || !loop_.contains(successor)) return false;
        if (seen.insert(successor).second) work.push_back(successor);
      }
    }
    return true;
  }

  Value* block_predicate(BasicBlock& block) {
    if (&block == header_) return builder_.getTrue();
    BasicBlock* dominator = dominators_.getNode(&block)->getIDom()->getBlock();
    if (always_follows(block, *dominator)) return predicates_[dominator];
    Value* any = nullptr;
    SmallPtrSet<BasicBlock*, 4> seen;
    for (BasicBlock* from : predecessors(&block)) {
      if (!seen.insert(from).second) continue;
      Value* taken = edge(from, &block);
      any = any ? builder_.CreateLogicalOr(any, taken) : taken;
    }
    return any;
  }

  void convert(BasicBlock& block) {
    Value* predicate = predicates_[&block] = block_predicate(block);
    for (Instruction& instruction : make_early_inc_range(block)) {
      if (instruction.isTerminator()) break;
      if (auto* phi = dyn_cast<PHINode>(&instruction)) {
        if (&block == header_)
          phi->moveBefore(*merged_, merged_->getFirstNonPHIIt());
        else
          select_phi(*phi);
      } else {
        move(instruction, predicate);
      }
    }
    // Edges out of the block use its terminator, which goes away with the block: compute them now.
    for (BasicBlock* successor : successors(&block)) edge(&block, successor);
  }

  void select_phi(PHINode& phi) {
    Value* value = nullptr;
    SmallPtrSet<BasicBlock*, 4> seen;
    for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
      BasicBlock* from = phi.getIncomingBlock(i);
      if (!seen.insert(from).second) continue;
      Value* incoming = phi.getIncomingValue(i);
      value = value ? builder_.CreateSelect(edge(from, phi.getParent()), incoming, value) : incoming;
    }
    if (auto* made = dyn_cast<Instruction>(value);
        made && made->getParent() == merged_ && made != phi.getIncomingValue(0)) {
      made->takeName(&phi);
      if (!made->getDebugLoc()) made->setDebugLoc(phi.getDebugLoc());
    }
    phi.replaceAllUsesWith(value);
    phi.eraseFromParent();
  }

  void move(Instruction& instruction, Value* predicate) {
    auto* constant = dyn_cast<ConstantInt>(predicate);
    bool always = constant && constant->isOne();
    if (isa<AssumeInst>(instruction) && !always) {
      instruction.eraseFromParent();  // What holds on one path does not hold on all.
      return;
    }
    instruction.moveBefore(*merged_, merged_->end());
    builder_.SetInsertPoint(merged_);
    if (always) return;
    auto* call = dyn_cast<CallInst>(&instruction);
    if (call && primitive_of(*call) != Primitive::kNone)
      predicate_call(*call, predicate);
    else if (call && call->getCalledFunction() && !call->getCalledFunction()->isDeclaration())
      throw CompileError(nearest_location(*call),
                         "this call of a DATAFLOW loop stands in a branch; put the branch into the process");
    else if (instruction.getOpcode() == Instruction::UDiv || instruction.getOpcode() == Instruction::SDiv ||
             instruction.getOpcode() == Instruction::URem || instruction.getOpcode() == Instruction::SRem)
      guard_divisor(instruction, predicate);
  }

  /// The access may have a predicate of its own already.
  void predicate_call(CallInst& call, Value* predicate) {
    builder_.SetInsertPoint(&call);
    call.setArgOperand(call.arg_size() - 1, both(predicate, own_predicate(call)));
    builder_.SetInsertPoint(merged_);
  }
  static Value* own_predicate(CallInst& call) {
    Value* own = call.getArgOperand(call.arg_size() - 1);
    auto* constant = dyn_cast<ConstantInt>(own);
    return constant && constant->isOne() ? nullptr : own;
  }

  /// A division that the program skips must not trap when it is computed anyway.
  void guard_divisor(Instruction& division, Value* predicate) {
    Value* divisor = division.getOperand(1);
    if (isa<ConstantInt>(divisor)) return;
    builder_.SetInsertPoint(&division);
    division.setOperand(1,
                        builder_.CreateSelect(predicate, divisor, ConstantInt::get(divisor->getType(), 1)));
    builder_.SetInsertPoint(merged_);
  }

  Value* exit_condition() {
    Value* any = builder_.getFalse();
    for (Exit& exit : exits_) {
      exit.taken = edge(exit.from, exit.to);
      any = isa<ConstantInt>(any) ? exit.taken : builder_.CreateLogicalOr(any, exit.taken);
    }
    return any;
  }

  void retarget_header_phis() {
    for (PHINode& phi : merged_->phis()) phi.replaceIncomingBlockWith(latch_, merged_);
    BasicBlock* preheader = loop_.getLoopPreheader();
    preheader->getTerminator()->replaceSuccessorWith(header_, merged_);
  }

  /// Branches back or out. Behind the loop, a chain of branches finds the exit that was taken.
  void finish(Value* leave, MDNode* id) {
    SmallVector<BasicBlock*, 4> targets;
    for (const Exit& exit : exits_)
      if (!is_contained(targets, exit.to)) targets.push_back(exit.to);
    for (BasicBlock* target : targets) merge_exit_phis(*target);

    BasicBlock* next = targets.empty() ? nullptr : targets.back();
    for (size_t i = targets.size(); i-- > 1;) {
      BasicBlock* dispatch = BasicBlock::Create(merged_->getContext(), merged_->getName() + ".exit",
                                                merged_->getParent(), targets[i]);
      IRBuilder<> out(dispatch);
      out.CreateCondBr(taken(*targets[i - 1]), targets[i - 1], next);
      set_exit_source(*targets[i - 1], *dispatch);
      if (i + 1 == targets.size()) set_exit_source(*targets[i], *dispatch);
      next = dispatch;
    }
    if (targets.size() == 1) set_exit_source(*targets[0], *merged_);
    builder_.SetInsertPoint(merged_);
    BranchInst* branch =
        targets.empty() ? builder_.CreateBr(merged_) : builder_.CreateCondBr(leave, next, merged_);
    branch->setMetadata(LLVMContext::MD_loop, id);
  }

  Value* taken(BasicBlock& target) {
    Value* any = nullptr;
    for (const Exit& exit : exits_)
      if (exit.to == &target) any = any ? builder_.CreateLogicalOr(any, exit.taken) : exit.taken;
    return any;
  }

  /// The exit's phis have one incoming value per exiting block; select among them inside the loop.
  void merge_exit_phis(BasicBlock& target) {
    for (PHINode& phi : target.phis()) {
      Value* value = nullptr;
      for (const Exit& exit : exits_) {
        if (exit.to != &target) continue;
        Value* incoming = phi.getIncomingValueForBlock(exit.from);
        value = value ? builder_.CreateSelect(exit.taken, incoming, value) : incoming;
      }
      while (phi.getNumIncomingValues() > 1) phi.removeIncomingValue(1u, false);
      phi.setIncomingValue(0, value);
    }
  }

  static void set_exit_source(BasicBlock& target, BasicBlock& source) {
    for (PHINode& phi : target.phis()) phi.setIncomingBlock(0, &source);
  }

  Loop& loop_;
  LoopInfo& loops_;
  DominatorTree& dominators_;
  IRBuilder<> builder_;
  BasicBlock* header_ = nullptr;
  BasicBlock* latch_ = nullptr;
  BasicBlock* merged_ = nullptr;
  std::vector<BasicBlock*> order_;
  std::vector<Exit> exits_;
  std::map<BasicBlock*, Value*> predicates_;
  std::map<std::pair<BasicBlock*, BasicBlock*>, Value*> edges_;
};

}  // namespace

void if_convert(Loop& loop, LoopInfo& loops, DominatorTree& dominators) {
  IfConverter(loop, loops, dominators).run();
}

}  // namespace hlsc
