#include "middle/stream_lowering.h"

#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

Value* leaf_address(IRBuilder<>& builder, Value* object, const Leaf& leaf) {
  return leaf.byte_offset ? builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), object, leaf.byte_offset)
                          : object;
}

/// Those of hls::stream_of_blocks.
bool locks(const CallInst& call) { return call.getCalledFunction()->getName().contains("_lock"); }

void lower_read(CallInst& call, const TypeLayout& layout) {
  IRBuilder<> builder(&call);
  Value* packed = create_read(builder, call.getArgOperand(0), layout.width(), builder.getTrue(), locks(call));
  packed->setName("data");
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
  create_write(builder, call.getArgOperand(0), packed, builder.getTrue(), locks(call));
}

void lower_status(CallInst& call, const char* name) {
  IRBuilder<> builder(&call);
  Value* answer = create_status(builder, name, call.getArgOperand(0));
  call.replaceAllUsesWith(builder.CreateZExt(answer, call.getType()));
}

}  // namespace

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
