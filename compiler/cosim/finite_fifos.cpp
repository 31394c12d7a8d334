#include "cosim/finite_fifos.h"

#include <llvm/Demangle/Demangle.h>
#include <llvm/Transforms/IPO/FunctionAttrs.h>
#include <llvm/Transforms/Scalar/SROA.h>

#include "middle/directives_to_ir.h"
#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

bool is_stream(const Type* type) {
  auto* structure = dyn_cast<StructType>(type);
  return structure && structure->hasName() && structure->getName().starts_with("class.hls::stream");
}

/// Byte offsets of the streams in an object.
void collect_streams(const DataLayout& layout, Type* type, uint64_t offset, std::vector<uint64_t>& found) {
  if (is_stream(type)) {
    found.push_back(offset);
  } else if (auto* array = dyn_cast<ArrayType>(type)) {
    uint64_t stride = layout.getTypeAllocSize(array->getElementType());
    for (uint64_t i = 0; i < array->getNumElements(); ++i)
      collect_streams(layout, array->getElementType(), offset + i * stride, found);
  } else if (auto* structure = dyn_cast<StructType>(type)) {
    for (unsigned i = 0; i < structure->getNumElements(); ++i)
      collect_streams(layout, structure->getElementType(i),
                      offset + layout.getStructLayout(structure)->getElementOffset(i), found);
  }
}

/// Locals to values, as far as it takes to tell which parameters a function writes to.
void infer_attributes(Module& module) {
  LoopAnalysisManager loops;
  FunctionAnalysisManager functions;
  CGSCCAnalysisManager components;
  ModuleAnalysisManager modules;
  PassBuilder builder;
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(components);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, components, modules);
  ModulePassManager passes;
  passes.addPass(createModuleToFunctionPassAdaptor(SROAPass(SROAOptions::PreserveCFG)));
  passes.addPass(createModuleToPostOrderCGSCCPassAdaptor(PostOrderFunctionAttrsPass()));
  passes.run(module, modules);
}

class ProcessMaker {
 public:
  explicit ProcessMaker(Program& program)
      : program_(program), module_(*program.module), layout_(module_.getDataLayout()) {
    Type* pointer = PointerType::get(module_.getContext(), 0);
    Type* size = Type::getInt64Ty(module_.getContext());
    Type* nothing = Type::getVoidTy(module_.getContext());
    start_ =
        module_.getOrInsertFunction("hlsc_process", nothing, pointer, pointer, size, pointer, pointer, size);
    declare_ = module_.getOrInsertFunction("hlsc_declare", nothing, pointer, size, pointer, pointer);
    await_ = module_.getOrInsertFunction("hlsc_await", nothing, pointer);
    join_ = module_.getOrInsertFunction("hlsc_join", nothing);
    place_ = module_.getOrInsertGlobal("hlsc_place", pointer);
  }

  void run() {
    Diagnostics ignored;  // Compilation tells them.
    resolve_loop_directives(module_, directives_, ignored);
    infer_attributes(module_);
    resolve_object_directives(module_, directives_, ignored);
    for (Function& function : module_) {
      for (Instruction& instruction : instructions(function))
        instruction.setMetadata(LLVMContext::MD_loop, nullptr);
      if (!function.isDeclaration()) tell_places(function);
    }
    for (Function& function : module_)
      if (!function.isDeclaration() && function_directive(function, "DATAFLOW")) make_processes(function);
  }

 private:
  Constant* text(const std::string& words) {
    GlobalVariable*& known = texts_[words];
    if (!known) {
      IRBuilder<> builder(module_.getContext());
      known = builder.CreateGlobalString(words, "hlsc_text", 0, &module_);
    }
    return known;
  }

  const std::string& name_of(const Function& process) const {
    return program_.functions.at(process.getName().str()).name;
  }

  static bool is_stream_member(const Function* function) {
    return function && demangle(function->getName().str()).rfind("hls::stream<", 0) == 0;
  }

  void tell_places(Function& function) {
    if (is_stream_member(&function)) return;
    for (Instruction& instruction : instructions(function)) {
      auto* call = dyn_cast<CallBase>(&instruction);
      if (call && is_stream_member(call->getCalledFunction()))
        new StoreInst(text(nearest_location(*call).text()), place_, call->getIterator());
    }
  }

  void make_processes(Function& region) {
    std::vector<CallBase*> calls;
    std::vector<ReturnInst*> returns;
    for (Instruction& instruction : instructions(region)) {
      auto* call = dyn_cast<CallBase>(&instruction);
      Function* callee = call ? call->getCalledFunction() : nullptr;
      bool is_process = callee && !callee->isDeclaration() && call->getType()->isVoidTy() &&
                        !call->hasStructRetAttr() && program_.functions.count(callee->getName().str());
      if (is_process) calls.push_back(call);
      if (auto* end = dyn_cast<ReturnInst>(&instruction)) returns.push_back(end);
    }
    for (CallBase* call : calls) await_results(region, *call);
    for (CallBase* call : calls) make_process(*call);
    for (ReturnInst* end : returns) CallInst::Create(join_, "", end->getIterator());
  }

  /// The region's own code uses what a process sets when the process has ended.
  void await_results(Function& region, CallBase& call) {
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      auto* local = dyn_cast<AllocaInst>(getUnderlyingObject(call.getArgOperand(i), 0));
      const Argument& parameter = *call.getCalledFunction()->getArg(i);
      if (!local || parameter.onlyReadsMemory() || holds_streams(parameter)) continue;
      for (Instruction& instruction : instructions(region)) {
        Value* pointer = getLoadStorePointerOperand(&instruction);
        if (pointer && getUnderlyingObject(pointer, 0) == local)
          CallInst::Create(await_, {local}, "", instruction.getIterator());
      }
    }
  }

  void make_process(CallBase& call) {
    Function& process = *call.getCalledFunction();
    std::vector<Type*> types;
    for (unsigned i = 0; i < call.arg_size(); ++i)
      types.push_back(call.isByValArgument(i) ? call.getParamByValType(i) : call.getArgOperand(i)->getType());
    StructType* arguments = StructType::get(module_.getContext(), types);
    IRBuilder<> at_entry(&*call.getFunction()->getEntryBlock().getFirstInsertionPt());
    AllocaInst* packed = at_entry.CreateAlloca(arguments);
    IRBuilder<> builder(&call);
    declare_streams(builder, call);
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      Value* place = builder.CreateStructGEP(arguments, packed, i);
      if (call.isByValArgument(i))
        builder.CreateMemCpy(place, Align(1), call.getArgOperand(i), Align(1),
                             layout_.getTypeAllocSize(types[i]));
      else
        builder.CreateStore(call.getArgOperand(i), place);
    }
    auto [objects, count] = objects_of(builder, at_entry, call);
    builder.CreateCall(start_, {body_of(process, call, arguments), packed,
                                builder.getInt64(layout_.getTypeAllocSize(arguments)), text(name_of(process)),
                                objects, count});
    if (auto* invoke = dyn_cast<InvokeInst>(&call)) {
      invoke->getUnwindDest()->removePredecessor(invoke->getParent());
      builder.CreateBr(invoke->getNormalDest());
    }
    call.eraseFromParent();
  }

  /// A function that takes the packed arguments and calls the process.
  Function* body_of(Function& process, CallBase& call, StructType* arguments) {
    auto* type = FunctionType::get(Type::getVoidTy(module_.getContext()),
                                   {PointerType::get(module_.getContext(), 0)}, false);
    Function* body = Function::Create(type, GlobalValue::InternalLinkage, "hlsc_body", module_);
    IRBuilder<> builder(BasicBlock::Create(module_.getContext(), "", body));
    std::vector<Value*> values;
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      Value* place = builder.CreateStructGEP(arguments, body->getArg(0), i);
      values.push_back(call.isByValArgument(i) ? place
                                               : builder.CreateLoad(arguments->getElementType(i), place));
    }
    CallInst* made = builder.CreateCall(&process, values);
    made->setAttributes(call.getAttributes());
    made->setCallingConv(call.getCallingConv());
    builder.CreateRetVoid();
    return body;
  }

  /// The streams that the process takes and that lie in the DATAFLOW function or are static.
  void declare_streams(IRBuilder<>& builder, CallBase& call) {
    for (Value* argument : call.args()) {
      if (!argument->getType()->isPointerTy()) continue;
      Value* object = getUnderlyingObject(argument, 0);
      Type* type = nullptr;
      if (auto* local = dyn_cast<AllocaInst>(object)) type = local->getAllocatedType();
      if (auto* global = dyn_cast<GlobalVariable>(object)) type = global->getValueType();
      std::vector<uint64_t> streams;
      if (type) collect_streams(layout_, type, 0, streams);
      for (size_t i = 0; i < streams.size(); ++i) {
        uint64_t offset = streams[i];
        long depth = 0;
        for (const ObjectDirective& entry : directives_.of(object, "STREAM"))
          if (!entry.bytes || (offset >= entry.offset && offset < entry.offset + entry.bytes))
            depth = std::max(1l, entry.directive.integer("depth", 2));
        std::string name = object->getName().str();
        if (streams.size() > 1) name += "[" + std::to_string(i) + "]";
        builder.CreateCall(declare_,
                           {builder.CreateConstGEP1_64(builder.getInt8Ty(), object, offset),
                            builder.getInt64(depth), text(name), text(name_of(*call.getCalledFunction()))});
      }
    }
  }

  bool holds_streams(const Argument& argument) const {
    const FunctionInfo& info = program_.functions.at(argument.getParent()->getName().str());
    return any_of(info.parameters, [&](const Parameter& parameter) {
      return argument.getName() == parameter.name && !parameter.streams.empty();
    });
  }

  /// A table of the objects, other than streams, that the process takes by their address.
  std::pair<Value*, Value*> objects_of(IRBuilder<>& builder, IRBuilder<>& at_entry, CallBase& call) {
    std::vector<std::pair<Value*, bool>> objects;
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      Value* argument = call.getArgOperand(i);
      if (!argument->getType()->isPointerTy() || call.isByValArgument(i)) continue;
      const Argument& parameter = *call.getCalledFunction()->getArg(i);
      if (!holds_streams(parameter))
        objects.push_back({getUnderlyingObject(argument, 0), !parameter.onlyReadsMemory()});
    }
    StructType* entry = StructType::get(builder.getPtrTy(), builder.getInt8Ty());
    ArrayType* table = ArrayType::get(entry, std::max<size_t>(1, objects.size()));
    AllocaInst* place = at_entry.CreateAlloca(table);
    for (size_t i = 0; i < objects.size(); ++i) {
      Value* at = builder.CreateConstInBoundsGEP2_64(table, place, 0, i);
      builder.CreateStore(objects[i].first, builder.CreateStructGEP(entry, at, 0));
      builder.CreateStore(builder.getInt8(objects[i].second), builder.CreateStructGEP(entry, at, 1));
    }
    return {place, builder.getInt64(objects.size())};
  }

  Program& program_;
  Module& module_;
  const DataLayout& layout_;
  DirectiveTable directives_;
  FunctionCallee start_, declare_, await_, join_;
  Constant* place_ = nullptr;
  std::map<std::string, GlobalVariable*> texts_;
};

}  // namespace

std::string finite_fifo_program(Program& program) {
  ProcessMaker(program).run();
  std::string text;
  raw_string_ostream(text) << *program.module;
  return text;
}

}  // namespace hlsc
