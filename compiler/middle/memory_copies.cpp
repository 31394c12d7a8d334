#include "middle/memory_copies.h"

#include <llvm/Transforms/Utils/BasicBlockUtils.h>

#include <functional>

#include "middle/llvm_headers.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr uint64_t kUnrolledLeaves = 32;

uint64_t leaf_count(Type* type) {
  if (auto* array = dyn_cast<ArrayType>(type))
    return array->getNumElements() * leaf_count(array->getElementType());
  if (auto* structure = dyn_cast<StructType>(type)) {
    uint64_t count = 0;
    for (Type* element : structure->elements()) count += leaf_count(element);
    return count;
  }
  return 1;
}

/// The type of the object a pointer points to, as far as its origin tells; null when unknown.
Type* pointee_type(Value* pointer) {
  if (auto* alloca = dyn_cast<AllocaInst>(pointer)) return alloca->getAllocatedType();
  if (auto* global = dyn_cast<GlobalVariable>(pointer)) return global->getValueType();
  if (auto* gep = dyn_cast<GEPOperator>(pointer)) return gep->getResultElementType();
  if (auto* select = dyn_cast<SelectInst>(pointer)) return pointee_type(select->getTrueValue());
  if (auto* phi = dyn_cast<PHINode>(pointer)) return pointee_type(phi->getIncomingValue(0));
  if (auto* argument = dyn_cast<Argument>(pointer)) {
    if (Type* type = argument->getParamByValType()) return type;
    return argument->getParamStructRetType();
  }
  return nullptr;
}

/// Clang does not copy the padding at a struct's end.
bool is_without_padding(Type* type, uint64_t size, uint64_t bytes) {
  return isa<StructType>(type) && bytes < size && size - bytes < 8;
}

/// A type of `bytes`, but for padding, from either pointer; an array's element type repeated when a part of
/// it is meant.
Type* copied_type(const DataLayout& layout, ArrayRef<Value*> pointers, uint64_t bytes) {
  for (Value* pointer : pointers) {
    for (Type* type = pointer ? pointee_type(pointer) : nullptr; type && type->isSized();) {
      uint64_t size = layout.getTypeAllocSize(type);
      if (size == bytes || is_without_padding(type, size, bytes)) return type;
      auto* array = dyn_cast<ArrayType>(type);
      auto* structure = dyn_cast<StructType>(type);
      if (array && size > bytes) {
        uint64_t stride = layout.getTypeAllocSize(array->getElementType());
        if (bytes > stride && bytes % stride == 0)
          return ArrayType::get(array->getElementType(), bytes / stride);
        type = array->getElementType();
      } else if (structure && size > bytes && structure->getNumElements()) {
        type = structure->getElementType(0);
      } else if (!array && !structure && size && bytes % size == 0 && isa<GEPOperator>(pointer)) {
        return ArrayType::get(type, bytes / size);  // &a[i], then several elements.
      } else {
        break;
      }
    }
  }
  bool is_integer = bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
  LLVMContext& context = pointers[0]->getContext();
  return is_integer ? Type::getIntNTy(context, bytes * 8) : nullptr;
}

/// Calls `body(builder, offset in bytes, leaf type)` for each leaf of `type`; the offset is an i64 value.
class LeafWalk {
 public:
  using Body = std::function<void(IRBuilder<>&, Value*, Type*)>;
  LeafWalk(const DataLayout& layout, Body body) : layout_(layout), body_(std::move(body)) {}

  /// Emits code before `at`, which stays the point after the walk.
  void walk(Type* type, Value* offset, Instruction* at) {
    IRBuilder<> builder(at);
    if (auto* structure = dyn_cast<StructType>(type)) {
      for (unsigned i = 0; i < structure->getNumElements(); ++i) {
        uint64_t member = layout_.getStructLayout(structure)->getElementOffset(i);
        builder.SetInsertPoint(at);
        walk(structure->getElementType(i), builder.CreateAdd(offset, builder.getInt64(member)), at);
      }
    } else if (auto* array = dyn_cast<ArrayType>(type)) {
      walk_array(array, offset, at);
    } else {
      body_(builder, offset, type);
    }
  }

 private:
  void walk_array(ArrayType* array, Value* offset, Instruction* at) {
    uint64_t stride = layout_.getTypeAllocSize(array->getElementType());
    if (leaf_count(array) <= kUnrolledLeaves) {
      for (uint64_t i = 0; i < array->getNumElements(); ++i) {
        IRBuilder<> builder(at);
        walk(array->getElementType(), builder.CreateAdd(offset, builder.getInt64(i * stride)), at);
      }
      return;
    }
    BasicBlock* before = at->getParent();
    BasicBlock* after = SplitBlock(before, at);
    BasicBlock* loop = BasicBlock::Create(before->getContext(), "copy", before->getParent(), after);
    before->getTerminator()->setSuccessor(0, loop);
    IRBuilder<> builder(loop);
    builder.SetCurrentDebugLocation(at->getDebugLoc());
    PHINode* index = builder.CreatePHI(builder.getInt64Ty(), 2, "copy_index");
    index->addIncoming(builder.getInt64(0), before);
    Value* element_offset = builder.CreateAdd(offset, builder.CreateMul(index, builder.getInt64(stride)));
    Value* next = builder.CreateNUWAdd(index, builder.getInt64(1));
    Value* more = builder.CreateICmpULT(next, builder.getInt64(array->getNumElements()));
    BranchInst* latch = builder.CreateCondBr(more, loop, after);
    walk(array->getElementType(), element_offset, latch);
    index->addIncoming(next, latch->getParent());
  }

  const DataLayout& layout_;
  Body body_;
};

Value* at_offset(IRBuilder<>& builder, Value* base, Value* offset) {
  if (auto* constant = dyn_cast<ConstantInt>(offset); constant && constant->isZero()) return base;
  return builder.CreateInBoundsGEP(builder.getInt8Ty(), base, offset);
}

void expand(MemIntrinsic& call) {
  const DataLayout& layout = call.getDataLayout();
  auto* length = dyn_cast<ConstantInt>(call.getLength());
  if (!length)
    throw CompileError(nearest_location(call),
                       "the size of a memory copy must be a constant; write a loop over the elements");
  Value* target = call.getRawDest();
  auto* transfer = dyn_cast<MemTransferInst>(&call);
  Value* source = transfer ? transfer->getRawSource() : nullptr;
  uint64_t bytes = length->getZExtValue();
  if (bytes == 0) return;
  Type* type = source ? copied_type(layout, {target, source}, bytes) : copied_type(layout, {target}, bytes);
  if (!type)
    throw CompileError(
        nearest_location(call),
        "cannot tell the type of the memory that is copied here; write a loop over the elements");
  LeafWalk walk(layout, [&](IRBuilder<>& builder, Value* offset, Type* leaf) {
    auto* place = dyn_cast<ConstantInt>(offset);
    if (place && place->getZExtValue() + layout.getTypeStoreSize(leaf) > bytes) return;  // Padding.
    Value* value;
    if (source) {
      value = builder.CreateAlignedLoad(leaf, at_offset(builder, source, offset), Align(1));
    } else {
      auto* fill = dyn_cast<ConstantInt>(cast<MemSetInst>(call).getValue());
      if (!fill)
        throw CompileError(nearest_location(call),
                           "memset takes a constant value here; write a loop over the elements");
      value =
          ConstantInt::get(call.getContext(), APInt::getSplat(leaf->getIntegerBitWidth(), fill->getValue()));
    }
    builder.CreateAlignedStore(value, at_offset(builder, target, offset), Align(1));
  });
  walk.walk(type, ConstantInt::get(Type::getInt64Ty(call.getContext()), 0), &call);
}

}  // namespace

void expand_memory_copies(Module& module) {
  std::vector<MemIntrinsic*> calls;
  for (Function& function : module)
    for (Instruction& instruction : instructions(function))
      if (auto* call = dyn_cast<MemIntrinsic>(&instruction)) calls.push_back(call);
  for (MemIntrinsic* call : calls) {
    expand(*call);
    call->eraseFromParent();
  }
}

}  // namespace hlsc
