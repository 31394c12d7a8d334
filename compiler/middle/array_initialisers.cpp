#include "middle/array_initialisers.h"

#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/BinaryFormat/Dwarf.h>

#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

/// Sizes of the array that the source declares; empty: it is none.
std::vector<uint64_t> declared_sizes(const GlobalVariable& global) {
  SmallVector<DIGlobalVariableExpression*, 1> debug;
  global.getDebugInfo(debug);
  const DIType* type = debug.empty() ? nullptr : debug[0]->getVariable()->getType();
  while (auto* derived = dyn_cast_or_null<DIDerivedType>(type))
    type = derived->getBaseType();  // const, typedef
  std::vector<uint64_t> sizes;
  auto* array = dyn_cast_or_null<DICompositeType>(type);
  if (!array || array->getTag() != dwarf::DW_TAG_array_type) return sizes;
  for (DINode* element : array->getElements()) {
    auto* range = dyn_cast<DISubrange>(element);
    auto* count = range ? dyn_cast_if_present<ConstantInt*>(range->getCount()) : nullptr;
    if (!count) return {};
    sizes.push_back(count->getZExtValue());
  }
  return sizes;
}

bool is_split_array(const Type* type) {
  auto* structure = dyn_cast<StructType>(type);
  return structure && structure->isLiteral() && structure->isPacked() && structure->getNumElements();
}

/// What the arrays and the parts of split ones in `type` hold.
Type* element_of(Type* type) {
  while (type->isArrayTy() || is_split_array(type))
    type = type->isArrayTy() ? type->getArrayElementType() : type->getStructElementType(0);
  return type;
}

/// The type by which the program subscripts the object as a whole; null when it does not.
Type* subscripted_type(const GlobalVariable& global, const DataLayout& layout) {
  for (const User* user : global.users()) {
    auto* gep = dyn_cast<GEPOperator>(user);
    Type* type = gep ? gep->getSourceElementType() : nullptr;
    if (type && type->isAggregateType() && !is_split_array(type) &&
        layout.getTypeAllocSize(type) == layout.getTypeAllocSize(global.getValueType()))
      return type;
  }
  return nullptr;
}

/// The type that the source declares; null when nothing tells.
Type* whole_type(const GlobalVariable& global, const DataLayout& layout) {
  if (Type* type = subscripted_type(global, layout)) return type;
  if (!is_split_array(global.getValueType())) return nullptr;
  std::vector<uint64_t> sizes = declared_sizes(global);
  Type* type = element_of(global.getValueType());
  for (size_t d = sizes.size(); d-- > 0;) type = ArrayType::get(type, sizes[d]);
  bool fits = layout.getTypeAllocSize(type) == layout.getTypeAllocSize(global.getValueType());
  return fits && !sizes.empty() ? type : nullptr;
}

/// What `initialiser` has from a byte on, as a value of `type`; null when it cannot be told.
Constant* value_at(Constant* initialiser, Type* type, uint64_t offset, const DataLayout& layout) {
  auto* array = dyn_cast<ArrayType>(type);
  auto* structure = dyn_cast<StructType>(type);
  if (!array && !structure) return ConstantFoldLoadFromConst(initialiser, type, APInt(64, offset), layout);
  std::vector<Constant*> parts;
  uint64_t count = array ? array->getNumElements() : structure->getNumElements();
  for (uint64_t i = 0; i < count; ++i) {
    Type* part = array ? array->getElementType() : structure->getElementType(i);
    uint64_t place = array ? i * layout.getTypeAllocSize(part).getFixedValue()
                           : layout.getStructLayout(structure)->getElementOffset(i).getFixedValue();
    Constant* value = value_at(initialiser, part, offset + place, layout);
    if (!value) return nullptr;
    parts.push_back(value);
  }
  return array ? ConstantArray::get(array, parts) : ConstantStruct::get(structure, parts);
}

bool holds_split_array(const Type* type) {
  return is_split_array(type) || any_of(type->subtypes(), holds_split_array);
}

}  // namespace

void restore_array_types(Module& module) {
  const DataLayout& layout = module.getDataLayout();
  std::vector<GlobalVariable*> globals;
  for (GlobalVariable& global : module.globals())
    if (global.hasInitializer() && holds_split_array(global.getValueType())) globals.push_back(&global);
  for (GlobalVariable* global : globals) {
    Type* type = whole_type(*global, layout);
    Constant* value = type ? value_at(global->getInitializer(), type, 0, layout) : nullptr;
    if (!value) continue;
    auto* whole = new GlobalVariable(module, value->getType(), global->isConstant(), global->getLinkage(),
                                     value, "", global);
    whole->copyAttributesFrom(global);
    whole->copyMetadata(global, 0);
    whole->takeName(global);
    global->replaceAllUsesWith(whole);
    global->eraseFromParent();
  }
}

}  // namespace hlsc
