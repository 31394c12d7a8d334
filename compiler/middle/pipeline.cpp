#include "middle/pipeline.h"

#include <llvm/ADT/SCCIterator.h>
#include <llvm/Analysis/CallGraph.h>
#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/IR/PatternMatch.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Transforms/AggressiveInstCombine/AggressiveInstCombine.h>
#include <llvm/Transforms/IPO/AlwaysInliner.h>
#include <llvm/Transforms/IPO/GlobalDCE.h>
#include <llvm/Transforms/IPO/GlobalOpt.h>
#include <llvm/Transforms/IPO/Internalize.h>
#include <llvm/Transforms/InstCombine/InstCombine.h>
#include <llvm/Transforms/Scalar/ADCE.h>
#include <llvm/Transforms/Scalar/BDCE.h>
#include <llvm/Transforms/Scalar/CorrelatedValuePropagation.h>
#include <llvm/Transforms/Scalar/DeadStoreElimination.h>
#include <llvm/Transforms/Scalar/EarlyCSE.h>
#include <llvm/Transforms/Scalar/GVN.h>
#include <llvm/Transforms/Scalar/IndVarSimplify.h>
#include <llvm/Transforms/Scalar/LICM.h>
#include <llvm/Transforms/Scalar/LoopDeletion.h>
#include <llvm/Transforms/Scalar/LoopPassManager.h>
#include <llvm/Transforms/Scalar/LoopRotation.h>
#include <llvm/Transforms/Scalar/LoopUnrollPass.h>
#include <llvm/Transforms/Scalar/SCCP.h>
#include <llvm/Transforms/Scalar/SROA.h>
#include <llvm/Transforms/Scalar/SimplifyCFG.h>
#include <llvm/Transforms/Utils/Evaluator.h>
#include <llvm/Transforms/Utils/LCSSA.h>
#include <llvm/Transforms/Utils/LoopSimplify.h>
#include <llvm/Transforms/Utils/LoopUtils.h>

#include "middle/array_access.h"
#include "middle/array_initialisers.h"
#include "middle/call_loop.h"
#include "middle/constant_tables.h"
#include "middle/dataflow_regions.h"
#include "middle/flatten.h"
#include "middle/host_calls.h"
#include "middle/if_convert.h"
#include "middle/llvm_headers.h"
#include "middle/memory_copies.h"
#include "middle/pointer_choices.h"
#include "middle/pointer_tables.h"
#include "middle/primitives.h"
#include "middle/source_location.h"
#include "middle/split_accesses.h"
#include "middle/static_objects.h"
#include "middle/stream_lowering.h"
#include "middle/stream_queues.h"
#include "middle/tasks.h"
#include "middle/union_locals.h"

namespace hlsc {
namespace {

using namespace llvm;
using namespace llvm::PatternMatch;

/// Loops to unroll in which a break and the last iteration leave by one branch, so that LLVM knows no trip
/// count: as many copies as the loop's own bound has iterations.
struct UnrollUpToTheBound : PassInfoMixin<UnrollUpToTheBound> {
  PreservedAnalyses run(Function& function, FunctionAnalysisManager& analyses) {
    ScalarEvolution& evolution = analyses.getResult<ScalarEvolutionAnalysis>(function);
    for (Loop* loop : analyses.getResult<LoopAnalysis>(function).getLoopsInPreorder()) {
      if (!getBooleanLoopAttribute(loop, "llvm.loop.unroll.full")) continue;
      BasicBlock* last = loop->getExitingBlock();
      auto* branch = last ? dyn_cast<BranchInst>(last->getTerminator()) : nullptr;
      if (branch && constant_bound(evolution, *loop, *branch))
        addStringMetadataToLoop(loop, "llvm.loop.unroll.count", evolution.getSmallConstantMaxTripCount(loop));
    }
    return PreservedAnalyses::all();
  }

 private:
  /// Whether one of the joined conditions alone ends the loop after a constant count.
  static bool constant_bound(ScalarEvolution& evolution, Loop& loop, BranchInst& branch) {
    bool leaves_if_true = !loop.contains(branch.getSuccessor(0));
    Value *first, *second;
    bool joined = leaves_if_true
                      ? match(branch.getCondition(), m_LogicalOr(m_Value(first), m_Value(second)))
                      : match(branch.getCondition(), m_LogicalAnd(m_Value(first), m_Value(second)));
    if (!joined) return false;
    return any_of(ArrayRef({first, second}), [&](Value* condition) {
      return isa<SCEVConstant>(
          evolution.computeExitLimitFromCond(&loop, condition, leaves_if_true, false).ExactNotTaken);
    });
  }
};

/// How deep loops may lie in each other whose bounds depend on the loops around them.
constexpr int kNestedUnrolls = 4;

bool has_loops_to_unroll(Module& module) {
  for (Function& function : module) {
    if (function.isDeclaration()) continue;
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    for (Loop* loop : loops.getLoopsInPreorder())
      if (getBooleanLoopAttribute(loop, "llvm.loop.unroll.full")) return true;
  }
  return false;
}

class Optimizer {
 public:
  explicit Optimizer(Module& module) : module_(module) {
    builder_.registerModuleAnalyses(module_analyses_);
    builder_.registerCGSCCAnalyses(cgscc_analyses_);
    builder_.registerFunctionAnalyses(function_analyses_);
    builder_.registerLoopAnalyses(loop_analyses_);
    builder_.crossRegisterProxies(loop_analyses_, function_analyses_, cgscc_analyses_, module_analyses_);
  }

  void drop_unused() {
    ModulePassManager passes;
    passes.addPass(GlobalDCEPass());
    passes.run(module_, module_analyses_);
  }

  void inline_all() {
    ModulePassManager passes;
    passes.addPass(AlwaysInlinerPass(/*InsertLifetime=*/false));
    passes.addPass(GlobalDCEPass());
    passes.run(module_, module_analyses_);
  }

  /// Unrolls what asks for it in a DATAFLOW function, before its calls and locals become hardware.
  void unroll_region(Function& region) {
    FunctionPassManager passes;
    passes.addPass(SROAPass(SROAOptions::ModifyCFG));
    passes.addPass(EarlyCSEPass());
    passes.addPass(createFunctionToLoopPassAdaptor(LoopRotatePass(/*EnableHeaderDuplication=*/true)));
    passes.addPass(LoopUnrollPass(LoopUnrollOptions(/*OptLevel=*/2, /*OnlyWhenForced=*/true)));
    passes.addPass(SCCPPass());
    passes.addPass(EarlyCSEPass());
    passes.addPass(SimplifyCFGPass(cfg_options()));
    function_analyses_.clear();
    passes.run(region, function_analyses_);
    function_analyses_.clear();
  }

  /// Locals to SSA values; keeps the addresses of arrays as Clang wrote them.
  void promote_locals() {
    FunctionPassManager passes;
    passes.addPass(SROAPass(SROAOptions::PreserveCFG));
    passes.addPass(EarlyCSEPass());
    run(std::move(passes));
  }

  void optimize() {
    ModulePassManager globals;
    globals.addPass(GlobalOptPass());
    globals.run(module_, module_analyses_);
    FunctionPassManager passes;
    simplify(passes);
    passes.addPass(createFunctionToLoopPassAdaptor(LoopRotatePass(/*EnableHeaderDuplication=*/true)));
    add_licm(passes);
    passes.addPass(createFunctionToLoopPassAdaptor(IndVarSimplifyPass(/*WidenIndVars=*/false)));
    passes.addPass(createFunctionToLoopPassAdaptor(LoopDeletionPass()));
    passes.addPass(UnrollUpToTheBound());
    passes.addPass(LoopUnrollPass(LoopUnrollOptions(/*OptLevel=*/2, /*OnlyWhenForced=*/true)));
    simplify(passes);
    run(std::move(passes));
    for (int level = 0; level < kNestedUnrolls && has_loops_to_unroll(module_); ++level) unroll_again();
    dissolve_constant_subscripts(module_);
    FunctionPassManager late;
    simplify(late);
    late.addPass(GVNPass(GVNOptions().setPRE(false).setLoadPRE(false)));
    late.addPass(CorrelatedValuePropagationPass());
    late.addPass(DSEPass());
    late.addPass(BDCEPass());
    simplify(late);
    late.addPass(createFunctionToLoopPassAdaptor(LoopRotatePass(true)));
    add_licm(late);
    late.addPass(createFunctionToLoopPassAdaptor(IndVarSimplifyPass(false)));
    late.addPass(ADCEPass());
    late.addPass(SimplifyCFGPass(cfg_options().sinkCommonInsts(false).hoistCommonInsts(true)));
    late.addPass(InstCombinePass());
    late.addPass(LoopSimplifyPass());
    late.addPass(LCSSAPass());
    run(std::move(late));
  }

  /// What became values of one call for the next. Nothing may leave the loop, in which arguments change; so
  /// no SimplifyCFG, which peels the first call off where it finds a branch by a start value.
  void simplify_call_loops() {
    FunctionPassManager passes;
    passes.addPass(EarlyCSEPass());
    passes.addPass(InstCombinePass());
    passes.addPass(LoopSimplifyPass());
    passes.addPass(LCSSAPass());
    function_analyses_.clear();
    for (Function& function : module_)
      if (is_call_loop(function)) passes.run(function, function_analyses_);
    function_analyses_.clear();
  }

  /// After if-conversion: merge predicates and drop what became equal. Must not touch the control flow.
  void clean_flat_code() {
    FunctionPassManager passes;
    passes.addPass(EarlyCSEPass());
    passes.addPass(InstCombinePass());
    passes.addPass(EarlyCSEPass());
    passes.addPass(BDCEPass());
    passes.addPass(ADCEPass());
    run(std::move(passes));
  }

  FunctionAnalysisManager& functions() { return function_analyses_; }

 private:
  static SimplifyCFGOptions cfg_options() {
    return SimplifyCFGOptions()
        .forwardSwitchCondToPhi(false)
        .convertSwitchToLookupTable(false)
        .convertSwitchRangeToICmp(true)
        .needCanonicalLoops(true);
  }
  void simplify(FunctionPassManager& passes) {
    passes.addPass(SROAPass(SROAOptions::ModifyCFG));
    passes.addPass(EarlyCSEPass(/*UseMemorySSA=*/true));
    passes.addPass(SimplifyCFGPass(cfg_options()));
    passes.addPass(InstCombinePass());
    passes.addPass(SCCPPass());
    passes.addPass(SimplifyCFGPass(cfg_options()));
    passes.addPass(InstCombinePass());
  }
  static void add_licm(FunctionPassManager& passes) {
    passes.addPass(createFunctionToLoopPassAdaptor(LICMPass(LICMOptions()), /*UseMemorySSA=*/true));
  }
  /// Loops whose bounds were the variables of a loop that has dissolved since.
  void unroll_again() {
    FunctionPassManager passes;
    passes.addPass(UnrollUpToTheBound());
    passes.addPass(LoopUnrollPass(LoopUnrollOptions(/*OptLevel=*/2, /*OnlyWhenForced=*/true)));
    simplify(passes);
    run(std::move(passes));
  }

  void run(FunctionPassManager passes) {
    ModulePassManager all;
    all.addPass(createModuleToFunctionPassAdaptor(std::move(passes)));
    all.run(module_, module_analyses_);
  }

  Module& module_;
  LoopAnalysisManager loop_analyses_;
  FunctionAnalysisManager function_analyses_;
  CGSCCAnalysisManager cgscc_analyses_;
  ModuleAnalysisManager module_analyses_;
  PassBuilder builder_;
};

/// Adds the functions that the DATAFLOW function `region` calls, in order of their calls. A callee that is
/// itself a DATAFLOW function dissolves into its caller.
void collect_processes(const Program& program, Function& region, std::vector<std::string>& processes) {
  for (Instruction& instruction : instructions(region)) {
    auto* call = dyn_cast<CallInst>(&instruction);
    Function* callee = call ? call->getCalledFunction() : nullptr;
    if (!callee || callee->isDeclaration() || !program.functions.count(callee->getName().str())) continue;
    if (function_directive(*callee, "DATAFLOW"))
      collect_processes(program, *callee, processes);
    else if (!is_contained(processes, callee->getName().str()))
      processes.push_back(callee->getName().str());
  }
}

std::vector<std::string> find_processes(const Program& program) {
  std::vector<std::string> processes;
  Function* top = program.module->getFunction(program.top);
  if (function_directive(*top, "DATAFLOW")) collect_processes(program, *top, processes);
  processes.push_back(program.top);
  return processes;
}

/// Calls with constant arguments that the program can answer at compile time (a constexpr function, may be
/// recursive) dissolve.
void evaluate_constant_calls(Module& module) {
  TargetLibraryInfoImpl library_info{Triple(module.getTargetTriple())};
  TargetLibraryInfo library(library_info);
  for (Function& caller : module)
    for (Instruction& instruction : make_early_inc_range(instructions(caller))) {
      auto* call = dyn_cast<CallInst>(&instruction);
      Function* callee = call ? call->getCalledFunction() : nullptr;
      if (!callee || callee == &caller || callee->isDeclaration() || !call->getType()->isIntegerTy())
        continue;
      SmallVector<Constant*, 4> arguments;
      for (Value* argument : call->args())
        if (auto* constant = dyn_cast<ConstantInt>(argument)) arguments.push_back(constant);
      if (arguments.empty() || arguments.size() != call->arg_size()) continue;
      Evaluator evaluator(module.getDataLayout(), &library);
      Constant* result = nullptr;
      bool known =
          evaluator.EvaluateFunction(callee, result, arguments) && isa_and_nonnull<ConstantInt>(result);
      if (!known || !evaluator.getMutatedInitializers().empty()) continue;
      call->replaceAllUsesWith(result);
      call->eraseFromParent();
    }
}

void refuse_recursion(Module& module) {
  CallGraph graph(module);
  for (auto scc = scc_begin(&graph); !scc.isAtEnd(); ++scc) {
    if (!scc.hasCycle()) continue;
    for (CallGraphNode* node : *scc) {
      Function* function = node->getFunction();
      if (!function || function->isDeclaration()) continue;
      SourceLocation where;
      if (DISubprogram* program = function->getSubprogram())
        where = {program->getFilename().str(), program->getLine(), 0};
      throw CompileError(
          where, "function '" + function->getName().str() +
                     "' calls itself; hardware has no call stack, write a loop with an explicit stack array");
    }
  }
}

void mark_for_inlining(Module& module, const std::vector<std::string>& processes) {
  for (Function& function : module) {
    if (function.isDeclaration()) continue;
    function.removeFnAttr(Attribute::NoInline);
    function.removeFnAttr(Attribute::OptimizeNone);
    bool is_process = is_contained(processes, function.getName().str());
    function.addFnAttr(is_process ? Attribute::NoInline : Attribute::AlwaysInline);
    if (!is_process && !function.hasLocalLinkage()) function.setLinkage(GlobalValue::InternalLinkage);
    function.setComdat(nullptr);
    if (is_process) function.setLinkage(GlobalValue::ExternalLinkage);
  }
  for (GlobalVariable& global : module.globals())
    if (!global.isDeclaration() && !global.hasAppendingLinkage()) {  // llvm.global_ctors keeps its own.
      global.setComdat(nullptr);
      global.setLinkage(GlobalValue::InternalLinkage);
    }
}

/// How deep functions that call what a pointer leads to may lie in each other.
constexpr int kPointerLevels = 4;

bool has_calls_to_inline(Module& module) {
  for (Function& function : module)
    for (Instruction& instruction : instructions(function)) {
      auto* call = dyn_cast<CallInst>(&instruction);
      Function* callee = call ? call->getCalledFunction() : nullptr;
      bool can_inline = callee && callee != &function && !callee->isDeclaration();
      if (can_inline && callee->hasFnAttribute(Attribute::AlwaysInline)) return true;
    }
  return false;
}

bool calls_functions(const Program& program, const Function& function) {
  return any_of(instructions(function), [&](const Instruction& instruction) {
    auto* call = dyn_cast<CallInst>(&instruction);
    const Function* callee = call ? call->getCalledFunction() : nullptr;
    return callee && program.functions.count(callee->getName().str());
  });
}

/// A DATAFLOW function of loops alone has no processes: it runs as it is written.
void drop_empty_regions(const Program& program, Diagnostics& diagnostics) {
  for (Function& function : *program.module) {
    if (function.isDeclaration() || !function_directive(function, "DATAFLOW")) continue;
    if (calls_functions(program, function)) continue;
    function.removeFnAttr("hls-dataflow");
    SourceLocation where;
    if (DISubprogram* source = function.getSubprogram())
      where = {source->getFilename().str(), source->getLine(), 0};
    diagnostics.warn(
        where,
        "DATAFLOW has no effect: processes are the functions that are called here, and there are "
        "none; put each loop into a function of its own");
  }
}

/// Unrolls the DATAFLOW functions' loops and separates their objects.
void prepare_regions(const Program& program, Optimizer& optimizer) {
  // LLVM unrolls no loop with a call that could be inlined; mark_for_inlining decides anew.
  for (Function& function : *program.module) function.addFnAttr(Attribute::NoInline);
  for (Function& function : *program.module) {
    if (function.isDeclaration() || !function_directive(function, "DATAFLOW")) continue;
    optimizer.unroll_region(function);
    separate_region_objects(program, function);
  }
}

/// Complains of loops that were to dissolve and did not, because their trip count is not known.
void check_unrolled(Function& function, Diagnostics& diagnostics) {
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  for (Loop* loop : loops.getLoopsInPreorder()) {
    std::optional<Directive> unroll = loop_directive(*loop, "UNROLL");
    if (!unroll || unroll->has("factor")) continue;
    SourceLocation where = location_of(*loop);
    if (!unroll->has("implied"))
      throw CompileError(where,
                         "the loop cannot be unrolled because its trip count is not known; give UNROLL "
                         "a factor, or the loop a constant bound");
    diagnostics.warn(where,
                     "this loop in a pipeline is not unrolled because its trip count is not known; it is "
                     "pipelined itself");
  }
}

bool returns(const Function& function) {
  return any_of(function, [](const BasicBlock& block) { return isa<ReturnInst>(block.getTerminator()); });
}

/// LATENCY is checked where the schedule is: of processes.
void warn_of_inlined_latency(const Module& module, const std::vector<std::string>& processes,
                             Diagnostics& diagnostics) {
  for (const Function& function : module) {
    const DISubprogram* place = function.getSubprogram();
    if (!place || !function_directive(function, "LATENCY") ||
        is_contained(processes, function.getName().str()))
      continue;
    diagnostics.warn({place->getFilename().str(), place->getLine(), 0},
                     "pragma 'LATENCY' has no effect in a function that is inlined");
  }
}

/// Calls of the processes that ask for PIPELINE overlap where they can.
void overlap_calls(const Program& program, const std::vector<std::string>& processes,
                   Diagnostics& diagnostics) {
  for (const std::string& name : processes) {
    Function& function = *program.module->getFunction(name);
    std::optional<Directive> pipeline = function_directive(function, "PIPELINE");
    auto info = program.functions.find(name);
    bool asks = pipeline && !pipeline->has("off") && !function_directive(function, "DATAFLOW");
    if (!asks || info == program.functions.end() || !returns(function)) continue;
    std::string reason = make_call_loop(info->second, function, processes.size() > 1);
    if (!reason.empty())
      diagnostics.warn(info->second.location,
                       "calls of '" + info->second.name + "' do not overlap as PIPELINE asks: " + reason);
  }
}

void convert_loops(Function& function, Optimizer& optimizer) {
  std::set<BasicBlock*> done;
  while (true) {
    optimizer.functions().clear();
    DominatorTree dominators(function);
    LoopInfo loops(dominators);
    Loop* next = nullptr;
    for (Loop* loop : loops.getLoopsInPreorder())
      if (is_pipelined(*loop) && loop->getNumBlocks() > 1) next = loop;
    if (!next) return;
    if (!next->isLoopSimplifyForm())
      throw CompileError(nearest_location(*next->getHeader()->begin()),
                         "this loop has an irregular shape (goto into it?); write it as for, while or do");
    if_convert(*next, loops, dominators);
  }
}

bool holds_stream_or_task(Type* type) {
  if (auto* array = dyn_cast<ArrayType>(type)) return holds_stream_or_task(array->getElementType());
  auto* structure = dyn_cast<StructType>(type);
  if (!structure) return false;
  StringRef name = structure->hasName() ? structure->getName() : "";
  return name.starts_with("class.hls::stream") || name.starts_with("class.hls::task") ||
         any_of(structure->elements(), holds_stream_or_task);
}

/// What a port without handshake gives does not change while C++ looks on, so accesses may be joined.
/// LLVM knows the values of these functions under their names in C alone.
void name_functions_of_reals(Module& module) {
  static const std::map<Intrinsic::ID, std::string> kNames = {
      {Intrinsic::tan, "tan"},   {Intrinsic::asin, "asin"}, {Intrinsic::acos, "acos"},
      {Intrinsic::atan, "atan"}, {Intrinsic::sinh, "sinh"}, {Intrinsic::cosh, "cosh"},
      {Intrinsic::tanh, "tanh"}};
  for (Function& function : make_early_inc_range(module)) {
    auto name = kNames.find(function.getIntrinsicID());
    bool is_double = name != kNames.end() && function.getReturnType()->isDoubleTy();
    if (!is_double && (name == kNames.end() || !function.getReturnType()->isFloatTy())) continue;
    FunctionCallee named =
        module.getOrInsertFunction(name->second + (is_double ? "" : "f"), function.getFunctionType());
    auto* callee = cast<Function>(named.getCallee());
    callee->setDoesNotAccessMemory();
    callee->setDoesNotThrow();
    callee->addFnAttr(Attribute::WillReturn);
    function.replaceAllUsesWith(callee);
    function.eraseFromParent();
  }
}

/// Clang marks the end of a static constant's construction for LLVM.
void drop_invariant_marks(Module& module) {
  for (Function& function : module)
    for (Instruction& instruction : make_early_inc_range(instructions(function))) {
      auto* mark = dyn_cast<IntrinsicInst>(&instruction);
      if (mark && mark->getIntrinsicID() == Intrinsic::invariant_start && mark->use_empty())
        mark->eraseFromParent();
    }
}

void drop_volatile(Module& module, Diagnostics& diagnostics) {
  for (Function& function : module)
    for (Instruction& instruction : instructions(function)) {
      if (!instruction.isVolatile() || instruction.isAtomic()) continue;
      diagnostics.warn(nearest_location(instruction),
                       "'volatile' has no effect: what is accessed here does not change during a run; use an "
                       "hls::stream for values that do");
      if (auto* load = dyn_cast<LoadInst>(&instruction)) load->setVolatile(false);
      if (auto* store = dyn_cast<StoreInst>(&instruction)) store->setVolatile(false);
      if (auto* copy = dyn_cast<MemIntrinsic>(&instruction))
        copy->setVolatile(ConstantInt::getFalse(module.getContext()));
    }
}

}  // namespace

bool declares_streams_or_tasks(const Module& module) {
  for (const GlobalVariable& global : module.globals())
    if (holds_stream_or_task(global.getValueType())) return true;
  for (const Function& function : module)
    for (const Instruction& instruction : instructions(function))
      if (auto* local = dyn_cast<AllocaInst>(&instruction);
          local && holds_stream_or_task(local->getAllocatedType()))
        return true;
  return false;
}

MiddleResult run_middle(Program& program, const LoopChoice& keeps_apart, bool in_sequence,
                        Diagnostics& diagnostics) {
  Module& module = *program.module;
  MiddleResult result;
  remove_host_calls(module, diagnostics);
  drop_volatile(module, diagnostics);
  place_tasks(module);
  drop_invariant_marks(module);
  name_functions_of_reals(module);
  resolve_loop_directives(module, result.directives, diagnostics);
  expand_memory_copies(module);
  lower_streams(module, program.stream_types);
  if (in_sequence)
    for (Function& function : module) function.removeFnAttr("hls-dataflow");
  drop_empty_regions(program, diagnostics);
  result.processes = find_processes(program);
  warn_of_inlined_latency(module, result.processes, diagnostics);
  Optimizer optimizer(module);
  prepare_regions(program, optimizer);
  mark_for_inlining(module, result.processes);
  evaluate_constant_calls(module);
  optimizer.drop_unused();
  refuse_recursion(module);
  optimizer.inline_all();
  optimizer.promote_locals();
  // A function behind a constant pointer is known when the locals that held the pointer are gone.
  for (int level = 0; level < kPointerLevels && has_calls_to_inline(module); ++level) {
    optimizer.inline_all();
    optimizer.promote_locals();
  }
  restore_array_types(module);
  unroll_inlined_loops(module);
  expand_remaining_copies(program);
  resolve_object_directives(module, result.directives, diagnostics);
  construct_static_objects(module);
  build_stream_queues(module, result.directives, diagnostics);
  optimizer.functions().clear();  // Copies and constructors changed the control flow.
  for (Function& function : module) {
    resolve_pointer_tables(function);
    resolve_pointer_choices(function);
  }
  optimizer.promote_locals();
  for (Function& function : module) {
    unions_to_integers(function);
    split_wide_accesses(function);
  }
  separate_subscripts(program, result.directives, diagnostics);
  optimizer.optimize();
  for (Function& function : module) make_tables_constant(function);
  for (const std::string& name : result.processes) check_unrolled(*module.getFunction(name), diagnostics);
  overlap_calls(program, result.processes, diagnostics);
  optimizer.simplify_call_loops();
  for (Function& function : module) {
    resolve_pointer_choices(function);
    accesses_to_primitives(function);
  }
  for (const std::string& name : result.processes)
    for (const SourceLocation& place : flatten_loops(*module.getFunction(name), keeps_apart, diagnostics))
      result.flattened.push_back(place);
  for (const std::string& name : result.processes) convert_loops(*module.getFunction(name), optimizer);
  optimizer.functions().clear();
  optimizer.clean_flat_code();
  if (verifyModule(module, &errs()))
    throw CompileError("internal: the middle produced invalid IR; please report this program");
  return result;
}

}  // namespace hlsc
