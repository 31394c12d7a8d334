#include "middle/static_objects.h"

#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/Transforms/Utils/Cloning.h>
#include <llvm/Transforms/Utils/CodeExtractor.h>
#include <llvm/Transforms/Utils/CtorUtils.h>
#include <llvm/Transforms/Utils/Evaluator.h>

#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

/// Runs a function without parameters; true when all it did are known stores to globals.
bool evaluate(Function& function) {
  TargetLibraryInfoImpl library_info{Triple(function.getParent()->getTargetTriple())};
  TargetLibraryInfo library(library_info);
  Evaluator evaluator(function.getDataLayout(), &library);
  Constant* result = nullptr;
  SmallVector<Constant*, 1> arguments;
  if (!evaluator.EvaluateFunction(&function, result, arguments)) return false;
  for (auto [global, initial] : evaluator.getMutatedInitializers()) global->setInitializer(initial);
  return true;
}

/// `if (guard == 0)` before the constructor of a static local: the branch; null for other branches.
BranchInst* guarded_branch(BasicBlock& block) {
  auto* branch = dyn_cast<BranchInst>(block.getTerminator());
  auto* test = branch && branch->isConditional() ? dyn_cast<ICmpInst>(branch->getCondition()) : nullptr;
  auto* load = test ? dyn_cast<LoadInst>(test->getOperand(0)) : nullptr;
  auto* guard = load ? dyn_cast<GlobalVariable>(load->getPointerOperand()) : nullptr;
  bool is_guard = guard && guard->getName().starts_with("_ZGV") && test->getPredicate() == CmpInst::ICMP_EQ;
  return is_guard ? branch : nullptr;
}

/// Tries to run the code under the guard; it goes away when that succeeds.
void construct_guarded(BranchInst& branch) {
  BasicBlock* start = branch.getSuccessor(0);
  BasicBlock* end = branch.getSuccessor(1);
  DominatorTree dominators(*branch.getFunction());
  SmallVector<BasicBlock*, 4> under_guard;
  dominators.getDescendants(start, under_guard);
  if (is_contained(under_guard, end) || start->getSinglePredecessor() != branch.getParent()) return;
  CodeExtractor extractor(under_guard, &dominators);
  CodeExtractorAnalysisCache cache(*branch.getFunction());
  SetVector<Value*> inputs, outputs, allocas;
  extractor.findInputsOutputs(inputs, outputs, allocas);
  if (!extractor.isEligible() || !inputs.empty() || !outputs.empty()) return;
  Function* constructor = extractor.extractCodeRegion(cache);
  if (!constructor) return;
  auto* call = cast<CallInst>(*constructor->user_begin());
  if (evaluate(*constructor)) {
    call->eraseFromParent();
    constructor->eraseFromParent();
  } else {
    InlineFunctionInfo info;
    InlineFunction(*call, info);
    constructor->eraseFromParent();
  }
}

SourceLocation first_location(const Function& function) {
  for (const Instruction& instruction : instructions(function))
    if (instruction.getDebugLoc()) return location_of(instruction);
  return {};
}

}  // namespace

void construct_static_objects(Module& module) {
  for (Function& function : module) {
    std::vector<BranchInst*> branches;
    for (BasicBlock& block : function)
      if (BranchInst* branch = guarded_branch(block)) branches.push_back(branch);
    for (BranchInst* branch : branches) construct_guarded(*branch);
  }
  optimizeGlobalCtorsList(module, [](uint32_t, Function* function) {
    if (evaluate(*function)) return true;
    throw CompileError(first_location(*function),
                       "the constructor of this global object cannot be run at compile time; make it "
                       "constexpr, or move the object into the function as a static local");
  });
}

}  // namespace hlsc
