#include "middle/tasks.h"

#include <llvm/Transforms/Utils/Cloning.h>
#include <llvm/Transforms/Utils/PromoteMemToReg.h>

#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr const char* kTask = "hls-task";

/// A constructor of hls::task or its operator(), or a constructor of hls::split and hls::merge, which call
/// it.
bool is_of_task(const Function& function) {
  StringRef name = function.getName();
  bool is_channel = name.starts_with("_ZN3hls5split") || name.starts_with("_ZN3hls5merge");
  return name.starts_with("_ZN3hls4task") || (is_channel && (name.contains("C1E") || name.contains("C2E")));
}

CallInst* next_call_of_task(Function& function) {
  for (Instruction& instruction : instructions(function)) {
    auto* call = dyn_cast<CallInst>(&instruction);
    Function* callee = call ? call->getCalledFunction() : nullptr;
    if (callee && !callee->isDeclaration() && is_of_task(*callee)) return call;
  }
  return nullptr;
}

/// In a function of hls::task the body is a parameter.
void mark_body_calls(Function& function) {
  for (Instruction& instruction : instructions(function))
    if (auto* call = dyn_cast<CallInst>(&instruction); call && call->isIndirectCall())
      call->addFnAttr(Attribute::get(function.getContext(), kTask));
}

/// Locals that hold one value, among them the body's and the streams' addresses.
void promote_scalars(Function& function) {
  DominatorTree dominators(function);
  std::vector<AllocaInst*> locals;
  for (Instruction& instruction : function.getEntryBlock())
    if (auto* local = dyn_cast<AllocaInst>(&instruction); local && isAllocaPromotable(local))
      locals.push_back(local);
  PromoteMemToReg(locals, dominators);
}

}  // namespace

void place_tasks(Module& module) {
  for (Function& function : module)
    if (!function.isDeclaration() && is_of_task(function)) mark_body_calls(function);
  for (Function& function : module) {
    if (function.isDeclaration() || is_of_task(function) || !next_call_of_task(function)) continue;
    while (CallInst* call = next_call_of_task(function)) {
      InlineFunctionInfo info;
      InlineFunction(*call, info);
    }
    promote_scalars(function);
  }
  for (Function& function : module)
    if (is_of_task(function) && function.use_empty()) function.deleteBody();
}

bool is_task(const CallInst& call) { return call.hasFnAttr(kTask); }

}  // namespace hlsc
