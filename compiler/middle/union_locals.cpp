#include "middle/union_locals.h"

#include "middle/byte_offset.h"
#include "middle/llvm_headers.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr uint64_t kMostBytes = 64;  ///< Beyond, a shift by any number of bytes is a large multiplexer.

/// What happens to a union.
struct Uses {
  std::vector<Instruction*> accesses, others;  ///< Loads and stores of integers; addresses and marks.
  bool has_variable_place = false;
  bool is_known = true;  ///< Nothing else happens to it.
};

void collect(Value& pointer, Uses& uses) {
  for (User* user : pointer.users()) {
    auto* instruction = cast<Instruction>(user);
    auto* load = dyn_cast<LoadInst>(user);
    auto* store = dyn_cast<StoreInst>(user);
    auto* gep = dyn_cast<GetElementPtrInst>(user);
    if (gep) {
      uses.has_variable_place |= !gep->hasAllConstantIndices();
      collect(*gep, uses);
      uses.others.push_back(gep);
    } else if ((load && load->getType()->isIntegerTy()) ||
               (store && store->getPointerOperand() == &pointer &&
                store->getValueOperand()->getType()->isIntegerTy())) {
      uses.accesses.push_back(instruction);
    } else if (instruction->isLifetimeStartOrEnd()) {
      uses.others.push_back(instruction);
    } else {
      uses.is_known = false;
    }
  }
}

class UnionRewriter {
 public:
  explicit UnionRewriter(AllocaInst& local)
      : layout_(local.getDataLayout()),
        local_(local),
        type_(IntegerType::get(local.getContext(), 8 * layout_.getTypeAllocSize(local.getAllocatedType()))),
        whole_(new AllocaInst(type_, local.getAddressSpace(), local.getName(), local.getIterator())) {}

  void rewrite(Instruction& access) {
    IRBuilder<> builder(&access);
    auto* store = dyn_cast<StoreInst>(&access);
    Value* pointer = store ? store->getPointerOperand() : cast<LoadInst>(access).getPointerOperand();
    Value* bits = builder.CreateShl(
        builder.CreateZExtOrTrunc(bytes_from(builder, layout_, &local_, pointer), type_), 3);
    Value* word = builder.CreateLoad(type_, whole_);
    if (store) {
      Value* part = store->getValueOperand();
      unsigned bytes = layout_.getTypeStoreSize(part->getType());
      Value* ones = builder.getInt(APInt::getLowBitsSet(type_->getBitWidth(), 8 * bytes));
      Value* rest = builder.CreateAnd(word, builder.CreateNot(builder.CreateShl(ones, bits)));
      builder.CreateStore(builder.CreateOr(rest, builder.CreateShl(builder.CreateZExt(part, type_), bits)),
                          whole_);
    } else {
      access.replaceAllUsesWith(builder.CreateTrunc(builder.CreateLShr(word, bits), access.getType()));
    }
    access.eraseFromParent();
  }

 private:
  const DataLayout& layout_;
  AllocaInst& local_;
  IntegerType* type_;
  AllocaInst* whole_;
};

bool is_small_union(const AllocaInst& local) {
  auto* type = dyn_cast<StructType>(local.getAllocatedType());
  return type && type->hasName() && type->getName().starts_with("union.") &&
         local.getDataLayout().getTypeAllocSize(type) <= kMostBytes;
}

}  // namespace

void unions_to_integers(Function& function) {
  std::vector<AllocaInst*> unions;
  for (Instruction& instruction : instructions(function))
    if (auto* local = dyn_cast<AllocaInst>(&instruction); local && is_small_union(*local))
      unions.push_back(local);
  for (AllocaInst* local : unions) {
    Uses uses;
    collect(*local, uses);
    if (!uses.is_known || !uses.has_variable_place) continue;
    UnionRewriter rewriter(*local);
    for (Instruction* access : uses.accesses) rewriter.rewrite(*access);
    for (Instruction* other : uses.others) other->eraseFromParent();
    local->eraseFromParent();
  }
}

}  // namespace hlsc
