#include "middle/pointer_choices.h"

#include <llvm/Analysis/Utils/Local.h>
#include <llvm/IR/GetElementPtrTypeIterator.h>
#include <llvm/Transforms/Utils/Local.h>

#include <numeric>

#include "middle/byte_offset.h"
#include "middle/primitives.h"

namespace hlsc {
namespace {

using namespace llvm;

/// The select or phi that an address starts from, behind GEPs; null when there is none.
Value* choice_behind(Value* pointer) {
  while (auto* gep = dyn_cast<GetElementPtrInst>(pointer)) pointer = gep->getPointerOperand();
  return isa<SelectInst>(pointer) || isa<PHINode>(pointer) ? pointer : nullptr;
}

/// The address with `arm` in place of the choice; GEPs between are cloned.
Value* rebuilt(IRBuilder<>& builder, Value* pointer, Value* choice, Value* arm) {
  if (pointer == choice) return arm;
  auto* gep = cast<GetElementPtrInst>(pointer);
  Value* base = rebuilt(builder, gep->getPointerOperand(), choice, arm);
  Instruction* copy = gep->clone();
  copy->setOperand(0, base);
  return builder.Insert(copy);
}

void split_select(Instruction& access, Value* pointer, SelectInst& choice) {
  IRBuilder<> builder(&access);
  Value* condition = choice.getCondition();
  auto* call = dyn_cast<CallInst>(&access);
  Value* predicate = call ? call->getArgOperand(call->arg_size() - 1) : builder.getTrue();
  Value* yes = builder.CreateLogicalAnd(predicate, condition);
  Value* no = builder.CreateLogicalAnd(predicate, builder.CreateNot(condition));
  Value* first = rebuilt(builder, pointer, &choice, choice.getTrueValue());
  Value* second = rebuilt(builder, pointer, &choice, choice.getFalseValue());
  if (!access.getType()->isVoidTy()) {
    Value* loaded = create_load(builder, first, access.getType(), yes);
    Value* other = create_load(builder, second, access.getType(), no);
    access.replaceAllUsesWith(builder.CreateSelect(condition, loaded, other));
  } else {
    Value* data = call ? call->getArgOperand(1) : cast<StoreInst>(access).getValueOperand();
    create_store(builder, first, data, yes);
    create_store(builder, second, data, no);
  }
  access.eraseFromParent();
}

/// Whether the load may move to the ends of the phi's predecessors: nothing is written before it, its
/// subscripts are constant.
bool can_move_up(LoadInst& load, Value* pointer, PHINode& phi) {
  if (load.getParent() != phi.getParent()) return false;
  for (Instruction& before : *load.getParent()) {
    if (&before == &load) break;
    if (before.mayWriteToMemory()) return false;
  }
  for (; pointer != &phi; pointer = cast<GetElementPtrInst>(pointer)->getPointerOperand())
    if (!cast<GetElementPtrInst>(pointer)->hasAllConstantIndices()) return false;
  return true;
}

void move_load_up(LoadInst& load, Value* pointer, PHINode& phi) {
  IRBuilder<> builder(&phi);
  PHINode* value = builder.CreatePHI(load.getType(), phi.getNumIncomingValues());
  std::map<BasicBlock*, Value*> made;
  for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
    BasicBlock* from = phi.getIncomingBlock(i);
    Value*& copy = made[from];
    if (!copy) {
      IRBuilder<> at_end(from->getTerminator());
      at_end.SetCurrentDebugLocation(load.getDebugLoc());
      Value* address = rebuilt(at_end, pointer, &phi, phi.getIncomingValue(i));
      copy = at_end.CreateAlignedLoad(load.getType(), address, load.getAlign());
    }
    value->addIncoming(copy, from);
  }
  value->takeName(&load);
  value->setDebugLoc(load.getDebugLoc());
  load.replaceAllUsesWith(value);
  load.eraseFromParent();
}

/// Pointer phis and selects that all lead into one object, as subscripts in units of the greatest common
/// step.
class PointerWeb {
 public:
  /// False when the pointers lead to several objects.
  bool collect(Value* start, const DataLayout& layout) {
    layout_ = &layout;
    SmallVector<Value*, 8> work = {start};
    while (!work.empty()) {
      Value* value = work.pop_back_val();
      if (auto* gep = dyn_cast<GEPOperator>(value)) {
        note_steps(*gep);
        work.push_back(gep->getPointerOperand());
      } else if (auto* phi = dyn_cast<PHINode>(value)) {
        if (!phis_.insert({phi, nullptr}).second) continue;
        order_.push_back(phi);
        for (Value* incoming : phi->incoming_values()) work.push_back(incoming);
      } else if (auto* select = dyn_cast<SelectInst>(value)) {
        work.push_back(select->getTrueValue());
        work.push_back(select->getFalseValue());
      } else if (!isa<AllocaInst>(value) && !isa<GlobalVariable>(value) && !isa<Argument>(value)) {
        return false;
      } else if (object_ && object_ != value) {
        return false;
      } else {
        object_ = value;
      }
    }
    return object_ && unit_ > 0;
  }

  void rewrite() {
    Type* index_type = Type::getInt64Ty(object_->getContext());
    for (PHINode* phi : order_)
      phis_[phi] = PHINode::Create(index_type, phi->getNumIncomingValues(), phi->getName() + ".index",
                                   phi->getIterator());
    for (PHINode* phi : order_)
      for (unsigned i = 0; i < phi->getNumIncomingValues(); ++i)
        phis_[phi]->addIncoming(index_of(phi->getIncomingValue(i), phi->getIncomingBlock(i)->getTerminator()),
                                phi->getIncomingBlock(i));
    for (PHINode* phi : order_) {
      IRBuilder<> builder(&*phi->getParent()->getFirstInsertionPt());
      Type* unit =
          unit_ == 1 ? builder.getInt8Ty() : static_cast<Type*>(ArrayType::get(builder.getInt8Ty(), unit_));
      phi->replaceAllUsesWith(builder.CreateInBoundsGEP(unit, object_, phis_[phi]));
    }
    for (PHINode* phi : order_) phi->eraseFromParent();
  }

 private:
  void note_steps(const GEPOperator& gep) {
    MapVector<Value*, APInt> terms;
    APInt constant(64, 0);
    if (!gep.collectOffset(*layout_, 64, terms, constant)) return;
    unit_ = std::gcd(unit_, std::abs(constant.getSExtValue()));
    for (auto& [value, scale] : terms) unit_ = std::gcd(unit_, std::abs(scale.getSExtValue()));
  }

  Value* index_of(Value* value, Instruction* at) {
    IRBuilder<> builder(at);
    if (value == object_) return builder.getInt64(0);
    if (auto* phi = dyn_cast<PHINode>(value)) return phis_[phi];
    if (auto* select = dyn_cast<SelectInst>(value))
      return builder.CreateSelect(select->getCondition(), index_of(select->getTrueValue(), at),
                                  index_of(select->getFalseValue(), at));
    auto* gep = cast<GEPOperator>(value);
    MapVector<Value*, APInt> terms;
    APInt constant(64, 0);
    gep->collectOffset(*layout_, 64, terms, constant);
    Value* index = index_of(gep->getPointerOperand(), at);
    builder.SetInsertPoint(at);
    if (!constant.isZero())
      index = builder.CreateNSWAdd(index, builder.getInt64(constant.getSExtValue() / unit_));
    for (auto& [term, scale] : terms)
      index = builder.CreateNSWAdd(index,
                                   builder.CreateNSWMul(builder.CreateSExtOrTrunc(term, builder.getInt64Ty()),
                                                        builder.getInt64(scale.getSExtValue() / unit_)));
    return index;
  }

  const DataLayout* layout_ = nullptr;
  Value* object_ = nullptr;
  int64_t unit_ = 0;
  std::map<PHINode*, PHINode*> phis_;
  std::vector<PHINode*> order_;
};

/// Whether the pointer comes back to the phi: `for (p = a; ...; ++p)`.
bool walks(PHINode& phi) {
  SmallVector<Value*, 8> work(phi.op_begin(), phi.op_end());
  SmallPtrSet<Value*, 8> seen;
  while (!work.empty()) {
    Value* value = work.pop_back_val();
    if (value == &phi) return true;
    if (!seen.insert(value).second) continue;
    if (auto* gep = dyn_cast<GEPOperator>(value)) work.push_back(gep->getPointerOperand());
    if (auto* other = dyn_cast<PHINode>(value)) work.append(other->op_begin(), other->op_end());
    if (auto* select = dyn_cast<SelectInst>(value))
      work.append({select->getTrueValue(), select->getFalseValue()});
  }
  return false;
}

/// Resolves one access; false when there was none to resolve.
bool resolve_one(Function& function) {
  for (Instruction& instruction : instructions(function)) {
    Value* pointer = accessed_pointer(instruction);
    Value* choice = pointer ? choice_behind(pointer) : nullptr;
    if (!choice) continue;
    if (auto* select = dyn_cast<SelectInst>(choice)) {
      split_select(instruction, pointer, *select);
      return true;
    }
    auto* phi = cast<PHINode>(choice);
    if (auto* load = dyn_cast<LoadInst>(&instruction);
        load && !walks(*phi) && can_move_up(*load, pointer, *phi)) {
      move_load_up(*load, pointer, *phi);
      return true;
    }
    PointerWeb web;
    if (web.collect(phi, function.getDataLayout())) {
      web.rewrite();
      return true;
    }
  }
  return false;
}

/// Pointer phis that nothing uses any more keep their objects alive.
void remove_dead_pointers(Function& function) {
  for (BasicBlock& block : function) {
    for (Instruction& instruction : make_early_inc_range(reverse(block)))
      if (instruction.getType()->isPointerTy() && isInstructionTriviallyDead(&instruction))
        instruction.eraseFromParent();
    for (PHINode& phi : make_early_inc_range(block.phis()))
      if (phi.getType()->isPointerTy()) RecursivelyDeleteDeadPHINode(&phi);
  }
}

/// `pointer != end` where both lead into one object compares places in it.
void compare_places(Function& function) {
  for (Instruction& instruction : make_early_inc_range(instructions(function))) {
    auto* compare = dyn_cast<ICmpInst>(&instruction);
    if (!compare || !compare->getOperand(0)->getType()->isPointerTy()) continue;
    Value* object = getUnderlyingObject(compare->getOperand(0), 0);
    if (object != getUnderlyingObject(compare->getOperand(1), 0)) continue;
    IRBuilder<> builder(compare);
    Value* first = bytes_from(builder, function.getDataLayout(), object, compare->getOperand(0));
    Value* second = bytes_from(builder, function.getDataLayout(), object, compare->getOperand(1));
    if (!first || !second) continue;
    compare->replaceAllUsesWith(builder.CreateICmp(compare->getSignedPredicate(), first, second));
    compare->eraseFromParent();
  }
}

}  // namespace

void resolve_pointer_choices(Function& function) {
  bool changed = false;
  while (resolve_one(function)) changed = true;
  if (!changed) return;
  compare_places(function);
  remove_dead_pointers(function);
}

}  // namespace hlsc
