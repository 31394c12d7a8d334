#include "middle/primitives.h"

#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

CallInst* call_primitive(IRBuilder<>& builder, const std::string& name, Type* result,
                         ArrayRef<Value*> arguments, MemoryEffects effects) {
  SmallVector<Type*, 4> types;
  for (Value* argument : arguments) types.push_back(argument->getType());
  Module& module = *builder.GetInsertBlock()->getModule();
  FunctionCallee callee = module.getOrInsertFunction(name, FunctionType::get(result, types, false));
  auto* function = cast<Function>(callee.getCallee());
  function->setDoesNotThrow();
  function->addFnAttr(Attribute::WillReturn);
  function->addFnAttr(Attribute::NoCallback);
  function->setMemoryEffects(effects);
  CallInst* call = builder.CreateCall(callee, arguments);
  // Merging the accesses of two branches would leave one access to a choice of streams or arrays.
  call->addFnAttr(Attribute::NoMerge);
  return call;
}

std::string typed(const char* name, const Type* type) {
  return std::string(name) + ".i" + std::to_string(type->getIntegerBitWidth());
}

// Streams are no memory of the program: loads and stores may move across their accesses, unless they lock it.
MemoryEffects stream_effects(bool is_lock = false) {
  return is_lock ? MemoryEffects::inaccessibleOrArgMemOnly() : MemoryEffects::inaccessibleMemOnly();
}

}  // namespace

Primitive primitive_of(const CallInst& call) {
  const Function* callee = call.getCalledFunction();
  if (!callee) return Primitive::kNone;
  StringRef name = callee->getName();
  if (!name.consume_front("hls.")) return Primitive::kNone;
  if (name.starts_with("read.")) return Primitive::kRead;
  if (name.starts_with("write.")) return Primitive::kWrite;
  if (name.starts_with("empty")) return Primitive::kEmpty;
  if (name.starts_with("full")) return Primitive::kFull;
  if (name.starts_with("load.")) return Primitive::kLoad;
  if (name.starts_with("store.")) return Primitive::kStore;
  if (name.starts_with("result.")) return Primitive::kResult;
  return Primitive::kNone;
}

bool is_lock(const CallInst& call) {
  const Function* callee = call.getCalledFunction();
  return callee &&
         (callee->getName().starts_with("hls.read.lock") || callee->getName().starts_with("hls.write.lock"));
}

CallInst* create_read(IRBuilder<>& builder, Value* stream, unsigned width, Value* predicate, bool is_lock) {
  Type* type = builder.getIntNTy(width);
  return call_primitive(builder, typed(is_lock ? "hls.read.lock" : "hls.read", type), type,
                        {stream, predicate}, stream_effects(is_lock));
}

CallInst* create_write(IRBuilder<>& builder, Value* stream, Value* data, Value* predicate, bool is_lock) {
  return call_primitive(builder, typed(is_lock ? "hls.write.lock" : "hls.write", data->getType()),
                        builder.getVoidTy(), {stream, data, predicate}, stream_effects(is_lock));
}

CallInst* create_status(IRBuilder<>& builder, const char* name, Value* stream) {
  return call_primitive(builder, name, builder.getInt1Ty(), {stream, builder.getTrue()}, stream_effects());
}

CallInst* create_load(IRBuilder<>& builder, Value* pointer, Type* type, Value* predicate) {
  return call_primitive(builder, typed("hls.load", type), type, {pointer, predicate},
                        MemoryEffects::argMemOnly(ModRefInfo::Ref));
}

CallInst* create_store(IRBuilder<>& builder, Value* pointer, Value* data, Value* predicate) {
  return call_primitive(builder, typed("hls.store", data->getType()), builder.getVoidTy(),
                        {pointer, data, predicate}, MemoryEffects::argMemOnly(ModRefInfo::ModRef));
}

void create_result(IRBuilder<>& builder, Value& value) {
  Value* all = &value;
  if (auto* structure = dyn_cast<StructType>(value.getType())) {
    unsigned width = 0;
    for (Type* part : structure->elements()) width += part->getIntegerBitWidth();
    all = builder.getIntN(width, 0);
    for (unsigned i = structure->getNumElements(); i-- > 0;) {
      Value* part = builder.CreateExtractValue(&value, i);
      all = builder.CreateShl(all, part->getType()->getIntegerBitWidth());
      all = builder.CreateOr(all, builder.CreateZExt(part, all->getType()));
    }
  }
  call_primitive(builder, typed("hls.result", all->getType()), builder.getVoidTy(), {all, builder.getTrue()},
                 stream_effects());
}

Value* accessed_pointer(Instruction& instruction) {
  if (auto* load = dyn_cast<LoadInst>(&instruction)) return load->getPointerOperand();
  if (auto* store = dyn_cast<StoreInst>(&instruction)) return store->getPointerOperand();
  auto* call = dyn_cast<CallInst>(&instruction);
  if (call && (primitive_of(*call) == Primitive::kLoad || primitive_of(*call) == Primitive::kStore))
    return call->getArgOperand(0);
  return nullptr;
}

void accesses_to_primitives(Function& function) {
  for (Instruction& instruction : make_early_inc_range(instructions(function))) {
    IRBuilder<> builder(&instruction);
    if (auto* load = dyn_cast<LoadInst>(&instruction); load && load->getType()->isIntegerTy()) {
      CallInst* call = create_load(builder, load->getPointerOperand(), load->getType(), builder.getTrue());
      call->takeName(load);
      load->replaceAllUsesWith(call);
      load->eraseFromParent();
    } else if (auto* store = dyn_cast<StoreInst>(&instruction);
               store && store->getValueOperand()->getType()->isIntegerTy()) {
      create_store(builder, store->getPointerOperand(), store->getValueOperand(), builder.getTrue());
      store->eraseFromParent();
    }
  }
}

}  // namespace hlsc
