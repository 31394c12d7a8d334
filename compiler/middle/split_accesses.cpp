#include "middle/split_accesses.h"

#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

/// A scalar inside an object.
struct Part {
  uint64_t offset;  ///< Bytes.
  Type* type;
};

/// Adds the scalars of `type`, which lies at `offset`, that touch bytes [first, end).
void collect_parts(const DataLayout& layout, Type* type, uint64_t offset, uint64_t first, uint64_t end,
                   std::vector<Part>& parts) {
  if (offset >= end || offset + layout.getTypeStoreSize(type) <= first) return;
  if (auto* structure = dyn_cast<StructType>(type)) {
    for (unsigned i = 0; i < structure->getNumElements(); ++i)
      collect_parts(layout, structure->getElementType(i),
                    offset + layout.getStructLayout(structure)->getElementOffset(i), first, end, parts);
  } else if (auto* array = dyn_cast<ArrayType>(type)) {
    uint64_t stride = layout.getTypeAllocSize(array->getElementType());
    if (stride == 0) return;
    uint64_t from = first > offset ? (first - offset) / stride : 0;
    for (uint64_t i = from; i < array->getNumElements() && offset + i * stride < end; ++i)
      collect_parts(layout, array->getElementType(), offset + i * stride, first, end, parts);
  } else {
    parts.push_back({offset, type});
  }
}

/// The type that `pointer` leads into, and the bytes from its start to the pointer; null when that is not
/// known.
std::pair<Type*, uint64_t> place_of(const DataLayout& layout, Value* pointer) {
  APInt offset(64, 0);
  while (auto* gep = dyn_cast<GEPOperator>(pointer)) {
    if (!gep->accumulateConstantOffset(layout, offset)) {
      // Bytes may be our own lowering's, which tells a step and no type.
      bool is_told = gep->getResultElementType()->isStructTy();
      return {is_told ? gep->getResultElementType() : nullptr, offset.getZExtValue()};
    }
    pointer = gep->getPointerOperand();
  }
  if (auto* local = dyn_cast<AllocaInst>(pointer)) return {local->getAllocatedType(), offset.getZExtValue()};
  if (auto* global = dyn_cast<GlobalVariable>(pointer))
    return {global->getValueType(), offset.getZExtValue()};
  return {nullptr, 0};
}

/// The parts that an access of `bytes` bytes covers as a whole, their offsets from the pointer; none when it
/// is no more than one.
std::vector<Part> covered_parts(const DataLayout& layout, Value* pointer, uint64_t bytes) {
  auto [type, offset] = place_of(layout, pointer);
  std::vector<Part> parts;
  if (type && type->isSized()) collect_parts(layout, type, 0, offset, offset + bytes, parts);
  for (Part& part : parts) {
    bool is_whole =
        part.offset >= offset && part.offset + layout.getTypeStoreSize(part.type) <= offset + bytes;
    if (!is_whole || !part.type->isIntegerTy()) return {};
    part.offset -= offset;
  }
  return parts.size() > 1 ? parts : std::vector<Part>();
}

Value* address_of(IRBuilder<>& builder, Value* pointer, const Part& part) {
  return part.offset ? builder.CreateConstInBoundsGEP1_64(builder.getInt8Ty(), pointer, part.offset)
                     : pointer;
}

void split_store(StoreInst& store, ArrayRef<Part> parts) {
  IRBuilder<> builder(&store);
  for (const Part& part : parts) {
    Value* value =
        builder.CreateTrunc(builder.CreateLShr(store.getValueOperand(), 8 * part.offset), part.type);
    builder.CreateAlignedStore(value, address_of(builder, store.getPointerOperand(), part), Align(1));
  }
}

void split_load(LoadInst& load, ArrayRef<Part> parts) {
  IRBuilder<> builder(&load);
  Value* whole = ConstantInt::get(load.getType(), 0);
  for (const Part& part : parts) {
    Value* value =
        builder.CreateAlignedLoad(part.type, address_of(builder, load.getPointerOperand(), part), Align(1));
    whole = builder.CreateOr(whole,
                             builder.CreateShl(builder.CreateZExt(value, load.getType()), 8 * part.offset));
  }
  load.replaceAllUsesWith(whole);
}

}  // namespace

void split_wide_accesses(Function& function) {
  for (Instruction& instruction : make_early_inc_range(instructions(function))) {
    if (instruction.isVolatile()) continue;
    const DataLayout& layout = instruction.getDataLayout();
    auto* store = dyn_cast<StoreInst>(&instruction);
    auto* load = dyn_cast<LoadInst>(&instruction);
    Type* type = store ? store->getValueOperand()->getType() : load ? load->getType() : nullptr;
    if (!type || !type->isIntegerTy()) continue;
    std::vector<Part> parts =
        covered_parts(layout, store ? store->getPointerOperand() : load->getPointerOperand(),
                      layout.getTypeStoreSize(type));
    if (parts.empty()) continue;
    if (store)
      split_store(*store, parts);
    else
      split_load(*load, parts);
    instruction.eraseFromParent();
  }
}

}  // namespace hlsc
