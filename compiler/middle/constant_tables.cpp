#include "middle/constant_tables.h"

#include <map>

#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

/// An array and what happens to it.
class Table {
 public:
  Table(Value& array, Type& type, Function& function)
      : array_(array), type_(type), function_(function), layout_(function.getDataLayout()) {}

  /// Whether constants alone are stored, and nothing but stores and loads happens.
  bool is_filled_with_constants() { return collect(array_, 0, true) && !stores_.empty() && !loads_.empty(); }

  bool is_filled_before_loads(const DominatorTree& dominators) const {
    for (StoreInst* store : stores_)
      if (store->getParent() != stores_[0]->getParent()) return false;
    return all_of(loads_, [&](LoadInst* load) {
      return all_of(stores_, [&](StoreInst* store) { return dominators.dominates(store, load); });
    });
  }

  /// False when a store covers another part than one element.
  bool make_constant() {
    std::map<uint64_t, Constant*> values;
    for (Instruction& instruction : *stores_[0]->getParent())
      if (auto place = places_.find(&instruction); place != places_.end())
        values[place->second] = cast<ConstantInt>(cast<StoreInst>(instruction).getValueOperand());
    auto* global = dyn_cast<GlobalVariable>(&array_);
    Constant* contents = value_of(&type_, global ? global->getInitializer() : nullptr, 0, values);
    if (!values.empty()) return false;
    for (StoreInst* store : stores_) store->eraseFromParent();
    for (Instruction* mark : marks_) mark->eraseFromParent();
    if (global) {
      global->setInitializer(contents);
      global->setConstant(true);
      return true;
    }
    auto* table = new GlobalVariable(*function_.getParent(), &type_, /*isConstant=*/true,
                                     GlobalValue::InternalLinkage, contents, array_.getName());
    array_.replaceAllUsesWith(table);
    cast<AllocaInst>(array_).eraseFromParent();
    return true;
  }

 private:
  bool collect(Value& pointer, uint64_t offset, bool is_constant) {
    for (User* user : pointer.users()) {
      auto* load = dyn_cast<LoadInst>(user);
      auto* store = dyn_cast<StoreInst>(user);
      auto* instruction = dyn_cast<Instruction>(user);
      APInt step(64, 0);
      if (instruction && instruction->getFunction() != &function_) return false;
      if (auto* gep = dyn_cast<GEPOperator>(user)) {
        bool is_known = gep->accumulateConstantOffset(layout_, step);
        if (!collect(*gep, offset + step.getZExtValue(), is_constant && is_known)) return false;
      } else if (load && load->getType()->isIntegerTy()) {
        loads_.push_back(load);
      } else if (store && is_constant && isa<ConstantInt>(store->getValueOperand())) {
        places_[store] = offset;
        stores_.push_back(store);
      } else if (instruction && instruction->isLifetimeStartOrEnd()) {
        marks_.push_back(instruction);
      } else {
        return false;
      }
    }
    return true;
  }

  /// Takes out of `values` what has its place in the type; the rest is as before, or zero.
  Constant* value_of(Type* type, Constant* before, uint64_t offset,
                     std::map<uint64_t, Constant*>& values) const {
    std::vector<Constant*> parts;
    auto add = [&](Type* part, unsigned index, uint64_t place) {
      Constant* old = before ? before->getAggregateElement(index) : nullptr;
      parts.push_back(value_of(part, old, offset + place, values));
    };
    if (auto* array = dyn_cast<ArrayType>(type)) {
      uint64_t stride = layout_.getTypeAllocSize(array->getElementType());
      for (uint64_t i = 0; i < array->getNumElements(); ++i) add(array->getElementType(), i, i * stride);
      return ConstantArray::get(array, parts);
    }
    if (auto* structure = dyn_cast<StructType>(type)) {
      for (unsigned i = 0; i < structure->getNumElements(); ++i)
        add(structure->getElementType(i), i, layout_.getStructLayout(structure)->getElementOffset(i));
      return ConstantStruct::get(structure, parts);
    }
    Constant* result = before ? before : Constant::getNullValue(type);
    if (auto value = values.find(offset); value != values.end() && value->second->getType() == type) {
      result = value->second;
      values.erase(value);
    }
    return result;
  }

  Value& array_;
  Type& type_;
  Function& function_;
  const DataLayout& layout_;
  std::map<Instruction*, uint64_t> places_;  ///< Of the stores, in bytes.
  std::vector<LoadInst*> loads_;
  std::vector<StoreInst*> stores_;
  std::vector<Instruction*> marks_;
};

}  // namespace

void make_tables_constant(Function& function) {
  if (function.isDeclaration()) return;
  DominatorTree dominators(function);
  std::vector<std::pair<Value*, Type*>> arrays;
  for (GlobalVariable& global : function.getParent()->globals())
    if (global.hasInternalLinkage() && global.hasInitializer() && !global.isConstant())
      arrays.push_back({&global, global.getValueType()});
  for (Instruction& instruction : instructions(function))
    if (auto* local = dyn_cast<AllocaInst>(&instruction))
      arrays.push_back({local, local->getAllocatedType()});
  for (auto [array, type] : arrays) {
    if (!type->isArrayTy()) continue;
    Table table(*array, *type, function);
    if (table.is_filled_with_constants() && table.is_filled_before_loads(dominators)) table.make_constant();
  }
}

}  // namespace hlsc
