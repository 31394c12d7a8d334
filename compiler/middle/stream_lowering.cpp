#include "middle/stream_lowering.h"

#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

FunctionCallee primitive(Module& module, const std::string& name, Type* result, ArrayRef<Type*> parameters) {
  FunctionCallee callee = module.getOrInsertFunction(name, FunctionType::get(result, parameters, false));
  auto* function = cast<Function>(callee.getCallee());
  function->setDoesNotThrow();
  function->addFnAttr(Attribute::WillReturn);
  function->addFnAttr(Attribute::NoCallback);
  // Streams are no memory of the program: loads and stores may move across their accesses.
  function->setMemoryEffects(MemoryEffects::inaccessibleMemOnly());
  return callee;
}

Value* leaf_address(IRBuilder<>& builder, Value* object, const Leaf& leaf) {
  return leaf.byte_offset ? builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), object, leaf.byte_offset)
                          : object;
}

void lower_read(CallInst& call, const TypeLayout& layout) {
  IRBuilder<> builder(&call);
  Type* packed_type = builder.getIntNTy(layout.width());
  FunctionCallee read = primitive(*call.getModule(), "hls.read.i" + std::to_string(layout.width()),
                                  packed_type, {builder.getPtrTy(), builder.getInt1Ty()});
  Value* packed = builder.CreateCall(read, {call.getArgOperand(0), builder.getTrue()}, "data");
  unsigned low = 0;
  for (const Leaf& leaf : layout.leaves) {
    Value* value =
        builder.CreateTrunc(builder.CreateLShr(packed, low), builder.getIntNTy(leaf.width), leaf.name);
    Value* stored = builder.CreateIntCast(value, builder.getIntNTy(leaf.bytes * 8), leaf.is_signed);
    builder.CreateAlignedStore(stored, leaf_address(builder, call.getArgOperand(1), leaf), Align(1));
    low += leaf.width;
  }
}

void lower_write(CallInst& call, const TypeLayout& layout) {
  IRBuilder<> builder(&call);
  Type* packed_type = builder.getIntNTy(layout.width());
  Value* packed = ConstantInt::get(packed_type, 0);
  unsigned low = 0;
  for (const Leaf& leaf : layout.leaves) {
    Value* stored =
        builder.CreateAlignedLoad(builder.getIntNTy(leaf.bytes * 8),
                                  leaf_address(builder, call.getArgOperand(1), leaf), Align(1), leaf.name);
    Value* value =
        builder.CreateZExt(builder.CreateTrunc(stored, builder.getIntNTy(leaf.width)), packed_type);
    packed = builder.CreateOr(packed, builder.CreateShl(value, low));
    low += leaf.width;
  }
  FunctionCallee write =
      primitive(*call.getModule(), "hls.write.i" + std::to_string(layout.width()), builder.getVoidTy(),
                {builder.getPtrTy(), packed_type, builder.getInt1Ty()});
  builder.CreateCall(write, {call.getArgOperand(0), packed, builder.getTrue()});
}

void lower_status(CallInst& call, const char* name) {
  IRBuilder<> builder(&call);
  FunctionCallee status =
      primitive(*call.getModule(), name, builder.getInt1Ty(), {builder.getPtrTy(), builder.getInt1Ty()});
  Value* answer = builder.CreateCall(status, {call.getArgOperand(0), builder.getTrue()});
  call.replaceAllUsesWith(builder.CreateZExt(answer, call.getType()));
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
  return Primitive::kNone;
}

void lower_streams(Module& module, const std::map<std::string, TypeLayout>& types) {
  for (const auto& [name, layout] : types) {
    Function* function = module.getFunction(name);
    if (!function) continue;
    for (User* user : make_early_inc_range(function->users())) {
      auto* call = cast<CallInst>(user);
      StringRef callee = function->getName();
      if (callee.contains("__hls_stream_read"))
        lower_read(*call, layout);
      else if (callee.contains("__hls_stream_write"))
        lower_write(*call, layout);
      else
        lower_status(*call, callee.contains("__hls_stream_empty") ? "hls.empty" : "hls.full");
      call->eraseFromParent();
    }
    function->eraseFromParent();
  }
}

}  // namespace hlsc
