#include "middle/call_loop.h"

#include <llvm/Analysis/CFG.h>
#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include "middle/array_access.h"
#include "middle/directives_to_ir.h"
#include "middle/flatten.h"
#include "middle/llvm_headers.h"
#include "middle/primitives.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr const char* kCallLoop = "hls-call-loop";

bool has_loops(const Function& function) {
  SmallVector<std::pair<const BasicBlock*, const BasicBlock*>, 4> back_edges;
  FindFunctionBackedges(function, back_edges);
  return !back_edges.empty();
}

bool is_stream(const FunctionInfo& info, const Argument& argument) {
  return any_of(info.parameters, [&](const Parameter& parameter) {
    return !parameter.streams.empty() && argument.getName() == parameter.name;
  });
}

/// Why the calls cannot overlap; empty when they can.
std::string hindrance(const FunctionInfo& info, Function& function, bool in_region) {
  if (has_loops(function)) {
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    return loops.empty()
               ? "its control flow is irregular (goto)"
               : "the loop at " + location_of(*loops.getLoopsInPreorder()[0]).text() + " is left in it";
  }
  if (!in_region) return "";
  if (!function.getReturnType()->isVoidTy()) return "its result goes to another process";
  for (const Argument& argument : function.args())
    if (argument.getType()->isPointerTy() && !is_stream(info, argument))
      return "'" + argument.getName().str() + "' is shared with other processes run by run";
  return "";
}

/// The parts of a static object that are each accessed as a whole: by their byte offset, the accesses.
using Parts = std::map<uint64_t, std::vector<Instruction*>>;

/// Collects the accesses through `pointer`; false when anything else happens to it, or elsewhere.
bool collect_parts(Value& pointer, uint64_t offset, const Function& function, Parts& parts) {
  const DataLayout& layout = function.getDataLayout();
  return all_of(pointer.users(), [&](User* user) {
    if (auto* gep = dyn_cast<GEPOperator>(user)) {
      APInt step(64, 0);
      return gep->accumulateConstantOffset(layout, step) &&
             collect_parts(*gep, offset + step.getZExtValue(), function, parts);
    }
    auto* access = dyn_cast<Instruction>(user);
    if (!access || access->getFunction() != &function || accessed_pointer(*access) != &pointer) return false;
    parts[offset].push_back(access);
    return true;
  });
}

Type* accessed_type(const Instruction& access) {
  auto* store = dyn_cast<StoreInst>(&access);
  return store ? store->getValueOperand()->getType() : access.getType();
}

/// Whether all accesses of a part have one type, and no two parts overlap.
bool are_apart(const Parts& parts, const DataLayout& layout) {
  uint64_t end = 0;
  for (const auto& [offset, accesses] : parts) {
    Type* type = accessed_type(*accesses[0]);
    bool is_one_type = all_of(accesses, [&](Instruction* access) { return accessed_type(*access) == type; });
    if (offset < end || !is_one_type || !type->isIntegerTy()) return false;
    end = offset + layout.getTypeStoreSize(type);
  }
  return true;
}

class CallLoop {
 public:
  explicit CallLoop(Function& function)
      : function_(function), context_(function.getContext()), header_(function.getEntryBlock()) {}

  void make() {
    entry_ = BasicBlock::Create(context_, "entry", &function_, &header_);
    header_.setName("calls");
    for (Instruction& instruction : make_early_inc_range(header_))
      if (isa<AllocaInst>(instruction)) instruction.moveBefore(*entry_, entry_->end());
    BranchInst::Create(&header_, entry_);
    lead_back();
    for (GlobalVariable& global : function_.getParent()->globals()) promote(global);
    DominatorTree dominators(function_);
    PromoteMemToReg(promoted_, dominators);
    function_.addFnAttr(kCallLoop);
  }

 private:
  /// Where the function ends, the next call begins. Places that control does not reach lead there, too.
  void lead_back() {
    latch_ = BasicBlock::Create(context_, "calls.latch", &function_);
    IRBuilder<> builder(latch_);
    PHINode* result = nullptr;
    if (Type* type = function_.getReturnType(); !type->isVoidTy()) {
      result = builder.CreatePHI(type, 2, "result");
      create_result(builder, *result);
    }
    for (BasicBlock& block : function_) {
      Instruction* end = block.getTerminator();
      auto* ret = dyn_cast_or_null<ReturnInst>(end);
      if (!ret && !isa_and_nonnull<UnreachableInst>(end)) continue;
      if (result)
        result->addIncoming(ret ? ret->getReturnValue() : PoisonValue::get(result->getType()), &block);
      if (ret && ret->getDebugLoc()) builder.SetCurrentDebugLocation(ret->getDebugLoc());
      BranchInst::Create(latch_, &block);
      end->eraseFromParent();
    }
    BranchInst* back = builder.CreateBr(&header_);
    back->setMetadata(LLVMContext::MD_loop, loop_id());
  }

  /// PIPELINE as on a written loop, and the function's place.
  MDNode* loop_id() {
    MDNode* id = with_directive(nullptr, *function_directive(function_, "PIPELINE"), context_);
    DISubprogram* source = function_.getSubprogram();
    if (!source) return id;
    SmallVector<Metadata*, 3> parts(id->op_begin(), id->op_end());
    parts.push_back(DILocation::get(context_, source->getLine(), 0, source));
    MDNode* placed = MDNode::getDistinct(context_, parts);
    placed->replaceOperandWith(0, placed);
    return placed;
  }

  void promote(GlobalVariable& global) {
    dissolve_constant_subscripts(global);
    Parts parts;
    const DataLayout& layout = function_.getDataLayout();
    bool is_state = !global.isConstant() && global.hasLocalLinkage() && global.hasInitializer() &&
                    collect_parts(global, 0, function_, parts) && are_apart(parts, layout);
    if (!is_state) return;
    for (const auto& [offset, accesses] : parts) {
      Type* type = accessed_type(*accesses[0]);
      Constant* start = ConstantFoldLoadFromConst(global.getInitializer(), type, APInt(64, offset), layout);
      if (!start) continue;
      IRBuilder<> builder(&*entry_->getFirstInsertionPt());
      AllocaInst* value = builder.CreateAlloca(type, nullptr, name_of(global));
      new StoreInst(start, value, entry_->getTerminator()->getIterator());
      for (Instruction* access : accesses)
        access->setOperand(isa<StoreInst>(access) ? StoreInst::getPointerOperandIndex() : 0, value);
      promoted_.push_back(value);
    }
  }

  static std::string name_of(const GlobalVariable& global) {
    SmallVector<DIGlobalVariableExpression*, 1> debug;
    global.getDebugInfo(debug);
    return debug.empty() ? global.getName().str() : debug[0]->getVariable()->getName().str();
  }

  Function& function_;
  LLVMContext& context_;
  BasicBlock& header_;
  BasicBlock *entry_ = nullptr, *latch_ = nullptr;
  std::vector<AllocaInst*> promoted_;
};

}  // namespace

std::string make_call_loop(const FunctionInfo& info, Function& function, bool in_region) {
  std::string reason = hindrance(info, function, in_region);
  if (reason.empty()) CallLoop(function).make();
  return reason;
}

bool is_call_loop(const Function& function) { return function.hasFnAttribute(kCallLoop); }

}  // namespace hlsc
