#include "middle/pointer_tables.h"

#include <llvm/Analysis/ConstantFolding.h>

#include <map>

#include "middle/byte_offset.h"
#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

/// A table and what happens to it.
class PointerTable {
 public:
  /// False when it is none, or something else happens to it.
  bool read(Value& table, Type* type, const DataLayout& layout) {
    auto* array = dyn_cast<ArrayType>(type);
    if (!array || !array->getElementType()->isPointerTy()) return false;
    table_ = &table;
    layout_ = &layout;
    bytes_ = layout.getTypeAllocSize(array->getElementType());
    if (auto* global = dyn_cast<GlobalVariable>(&table)) {
      if (!global->isConstant() || !global->hasInitializer()) return false;
      for (uint64_t i = 0; i < array->getNumElements(); ++i)
        entries_[i * bytes_] = global->getInitializer()->getAggregateElement(i);
    }
    return collect(table, 0, true) && (entries_.size() == array->getNumElements() || loads_.empty());
  }

  /// Whether no entry is a function.
  bool leads_to_data() const {
    return none_of(entries_, [](const auto& entry) { return isa<Function>(entry.second); });
  }

  /// Whether each entry is there before any load.
  bool is_set_before(const DominatorTree& dominators) const {
    for (StoreInst* store : stores_)
      for (LoadInst* load : loads_)
        if (!dominators.dominates(store, load)) return false;
    return true;
  }

  void resolve(Function& function) {
    for (LoadInst* load : loads_) {
      if (load->getFunction() != &function) continue;
      IRBuilder<> builder(load);
      Value* place = bytes_from(builder, *layout_, table_, load->getPointerOperand());
      Value* chosen = entries_.begin()->second;
      for (auto [bytes, entry] : entries_)
        if (entry != chosen)
          chosen = builder.CreateSelect(builder.CreateICmpEQ(place, builder.getInt64(bytes)), entry, chosen);
      load->replaceAllUsesWith(chosen);
      load->eraseFromParent();
    }
    for (StoreInst* store : stores_) store->eraseFromParent();
  }

 private:
  bool collect(Value& pointer, uint64_t offset, bool is_constant) {
    for (User* user : pointer.users()) {
      auto* gep = dyn_cast<GEPOperator>(user);
      APInt step(64, 0);
      if (gep) {
        bool is_known = gep->accumulateConstantOffset(*layout_, step);
        if (!collect(*gep, offset + step.getZExtValue(), is_constant && is_known)) return false;
      } else if (auto* load = dyn_cast<LoadInst>(user); load && load->getType()->isPointerTy()) {
        loads_.push_back(load);
      } else if (auto* store = dyn_cast<StoreInst>(user);
                 store && is_constant && store->getPointerOperand() == &pointer &&
                 store->getValueOperand()->getType()->isPointerTy() &&
                 entries_.emplace(offset, store->getValueOperand()).second) {
        stores_.push_back(store);
      } else if (auto* other = dyn_cast<Instruction>(user); !other || !other->isLifetimeStartOrEnd()) {
        return false;
      }
    }
    return true;
  }

  const DataLayout* layout_ = nullptr;
  Value* table_ = nullptr;
  uint64_t bytes_ = 0;
  std::map<uint64_t, Value*> entries_;  ///< By their place in bytes.
  std::vector<LoadInst*> loads_;
  std::vector<StoreInst*> stores_;
};

}  // namespace

void resolve_pointer_tables(Function& function) {
  if (function.isDeclaration()) return;
  const DataLayout& layout = function.getDataLayout();
  DominatorTree dominators(function);
  for (GlobalVariable& global : function.getParent()->globals())
    if (PointerTable table; table.read(global, global.getValueType(), layout) && table.leads_to_data())
      table.resolve(function);
  std::vector<AllocaInst*> locals;
  for (Instruction& instruction : instructions(function))
    if (auto* local = dyn_cast<AllocaInst>(&instruction)) locals.push_back(local);
  for (AllocaInst* local : locals)
    if (PointerTable table; table.read(*local, local->getAllocatedType(), layout) && table.leads_to_data() &&
                            table.is_set_before(dominators))
      table.resolve(function);
}

}  // namespace hlsc
