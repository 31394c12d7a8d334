#include "middle/memory_copies.h"

#include <llvm/Transforms/Utils/BasicBlockUtils.h>

#include <functional>
#include <limits>

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

/// The type of one element behind a parameter of a process, when it is a scalar.
Type* parameter_type(const Program* program, const Argument& argument) {
  if (!program) return nullptr;
  auto known = program->functions.find(argument.getParent()->getName().str());
  if (known == program->functions.end()) return nullptr;
  for (const Parameter& parameter : known->second.parameters)
    if (argument.getName() == parameter.name && parameter.layout.leaves.size() == 1)
      return Type::getIntNTy(argument.getContext(), parameter.layout.leaves[0].bytes * 8);
  return nullptr;
}

/// The type of the object a pointer points to, as far as its origin tells; null when unknown. `program` is
/// there once pointers lead to parameters.
Type* pointee_type(const Program* program, Value* pointer) {
  if (auto* alloca = dyn_cast<AllocaInst>(pointer)) return alloca->getAllocatedType();
  if (auto* global = dyn_cast<GlobalVariable>(pointer)) return global->getValueType();
  if (auto* gep = dyn_cast<GEPOperator>(pointer)) return gep->getResultElementType();
  if (auto* select = dyn_cast<SelectInst>(pointer)) return pointee_type(program, select->getTrueValue());
  if (auto* phi = dyn_cast<PHINode>(pointer)) return pointee_type(program, phi->getIncomingValue(0));
  if (auto* argument = dyn_cast<Argument>(pointer)) {
    if (Type* type = argument->getParamByValType()) return type;
    if (Type* type = argument->getParamStructRetType()) return type;
    return parameter_type(program, *argument);
  }
  return nullptr;
}

/// Clang does not copy the padding at a struct's end.
bool is_without_padding(Type* type, uint64_t size, uint64_t bytes) {
  return isa<StructType>(type) && bytes < size && size - bytes < 8;
}

/// A type of `bytes`, but for padding, from either pointer; an array's element type repeated when a part of
/// it is meant.
Type* copied_type(const Program* program, const DataLayout& layout, ArrayRef<Value*> pointers,
                  uint64_t bytes) {
  for (Value* pointer : pointers) {
    for (Type* type = pointer ? pointee_type(program, pointer) : nullptr; type && type->isSized();) {
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
      } else if (!array && !structure && size && bytes % size == 0 &&
                 (isa<GEPOperator>(pointer) || isa<Argument>(pointer))) {
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

/// The elements of an array that either pointer leads to; null when that is not known.
Type* element_type(const Program* program, ArrayRef<Value*> pointers) {
  for (Value* pointer : pointers) {
    Type* type = pointer ? pointee_type(program, pointer) : nullptr;
    while (type && type->isArrayTy()) type = type->getArrayElementType();
    if (type && type->isSized()) return type;
  }
  return nullptr;
}

/// A place in an object: constant bytes and subscripts of the copy's loops with the bytes of a step.
struct Place {
  uint64_t bytes = 0;
  std::vector<std::pair<Value*, uint64_t>> subscripts;
};

/// Calls `body(builder, place, leaf type)` for each leaf of `type`.
class LeafWalk {
 public:
  using Body = std::function<void(IRBuilder<>&, const Place&, Type*)>;
  LeafWalk(const DataLayout& layout, Body body) : layout_(layout), body_(std::move(body)) {}

  /// Walks as many elements of `type` as lie in `bytes`, a number known at run time only.
  void walk_bytes(Type* type, Value* bytes, Instruction* at) {
    IRBuilder<> builder(at);
    Value* count =
        builder.CreateUDiv(bytes, ConstantInt::get(bytes->getType(), layout_.getTypeAllocSize(type)));
    count = builder.CreateZExtOrTrunc(count, builder.getInt64Ty());
    BasicBlock* before = at->getParent();
    BasicBlock* after = SplitBlock(before, at);
    BasicBlock* loop = loop_over(type, count, {}, before, after, at->getDebugLoc());
    Instruction* jump = before->getTerminator();
    builder.SetInsertPoint(jump);
    builder.CreateCondBr(builder.CreateICmpEQ(count, builder.getInt64(0)), after, loop);
    jump->eraseFromParent();
  }

  /// Emits code before `at`, which stays the point after the walk.
  void walk(Type* type, const Place& place, Instruction* at) {
    if (auto* structure = dyn_cast<StructType>(type)) {
      for (unsigned i = 0; i < structure->getNumElements(); ++i)
        walk(structure->getElementType(i),
             moved(place, layout_.getStructLayout(structure)->getElementOffset(i)), at);
    } else if (auto* array = dyn_cast<ArrayType>(type)) {
      walk_array(array, place, at);
    } else {
      IRBuilder<> builder(at);
      body_(builder, place, type);
    }
  }

 private:
  static Place moved(Place place, uint64_t bytes) {
    place.bytes += bytes;
    return place;
  }

  void walk_array(ArrayType* array, const Place& place, Instruction* at) {
    uint64_t stride = layout_.getTypeAllocSize(array->getElementType());
    if (leaf_count(array) <= kUnrolledLeaves) {
      for (uint64_t i = 0; i < array->getNumElements(); ++i)
        walk(array->getElementType(), moved(place, i * stride), at);
      return;
    }
    BasicBlock* before = at->getParent();
    BasicBlock* after = SplitBlock(before, at);
    before->getTerminator()->setSuccessor(
        0, loop_over(array->getElementType(),
                     ConstantInt::get(Type::getInt64Ty(at->getContext()), array->getNumElements()), place,
                     before, after, at->getDebugLoc()));
  }

  /// A loop over `count` elements, at least one, that `before` enters and that leads to `after`.
  BasicBlock* loop_over(Type* type, Value* count, const Place& place, BasicBlock* before, BasicBlock* after,
                        const DebugLoc& where) {
    BasicBlock* loop = BasicBlock::Create(before->getContext(), "copy", before->getParent(), after);
    IRBuilder<> builder(loop);
    builder.SetCurrentDebugLocation(where);
    PHINode* index = builder.CreatePHI(builder.getInt64Ty(), 2, "copy_index");
    index->addIncoming(builder.getInt64(0), before);
    Place element = place;
    element.subscripts.push_back({index, layout_.getTypeAllocSize(type)});
    Value* next = builder.CreateNUWAdd(index, builder.getInt64(1));
    Value* more = builder.CreateICmpULT(next, count);
    BranchInst* latch = builder.CreateCondBr(more, loop, after);
    walk(type, element, latch);
    index->addIncoming(next, latch->getParent());
    return loop;
  }

  const DataLayout& layout_;
  Body body_;
};

Value* address_of(IRBuilder<>& builder, Value* base, const Place& place) {
  for (auto [subscript, stride] : place.subscripts)
    base = builder.CreateInBoundsGEP(ArrayType::get(builder.getInt8Ty(), stride), base, subscript);
  return place.bytes ? builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), base, place.bytes) : base;
}

/// Returns false, or throws when `program` is there, for copies that it cannot expand.
bool expand(const Program* program, MemIntrinsic& call) {
  const DataLayout& layout = call.getDataLayout();
  auto* length = dyn_cast<ConstantInt>(call.getLength());
  if (!length && !program) return false;
  Value* target = call.getRawDest();
  auto* transfer = dyn_cast<MemTransferInst>(&call);
  Value* source = transfer ? transfer->getRawSource() : nullptr;
  std::vector<Value*> pointers = {target};
  if (source) pointers.push_back(source);
  uint64_t bytes = length ? length->getZExtValue() : std::numeric_limits<uint64_t>::max();
  if (bytes == 0) return true;
  Type* type = length ? copied_type(program, layout, pointers, bytes) : element_type(program, pointers);
  if (!type && !program) return false;
  if (!type)
    throw CompileError(
        nearest_location(call),
        "cannot tell the type of the memory that is copied here; write a loop over the elements");
  LeafWalk walk(layout, [&](IRBuilder<>& builder, const Place& place, Type* leaf) {
    if (place.bytes + layout.getTypeStoreSize(leaf) > bytes) return;  // Padding.
    Value* value;
    if (source) {
      value = builder.CreateAlignedLoad(leaf, address_of(builder, source, place), Align(1));
    } else {
      auto* fill = dyn_cast<ConstantInt>(cast<MemSetInst>(call).getValue());
      if (!fill)
        throw CompileError(nearest_location(call),
                           "memset takes a constant value here; write a loop over the elements");
      value =
          ConstantInt::get(call.getContext(), APInt::getSplat(leaf->getIntegerBitWidth(), fill->getValue()));
    }
    builder.CreateAlignedStore(value, address_of(builder, target, place), Align(1));
  });
  if (length)
    walk.walk(type, {}, &call);
  else
    walk.walk_bytes(type, call.getLength(), &call);
  return true;
}

void expand_all(Module& module, const Program* program) {
  std::vector<MemIntrinsic*> calls;
  for (Function& function : module)
    for (Instruction& instruction : instructions(function))
      if (auto* call = dyn_cast<MemIntrinsic>(&instruction)) calls.push_back(call);
  for (MemIntrinsic* call : calls)
    if (expand(program, *call)) call->eraseFromParent();
}

}  // namespace

void expand_memory_copies(Module& module) { expand_all(module, nullptr); }

void expand_remaining_copies(const Program& program) { expand_all(*program.module, &program); }

}  // namespace hlsc
