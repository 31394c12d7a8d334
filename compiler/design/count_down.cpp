#include "design/count_down.h"

#include <algorithm>
#include <set>

namespace hlsc {
namespace {

/// By ValueId: the operations that use it; kNoValue stands for the end of a block.
using Users = std::vector<std::vector<ValueId>>;

Users users_of(const Process& process) {
  Users users(process.operations.size());
  auto use = [&](ValueId value, ValueId user) {
    if (value != kNoValue) users[value].push_back(user);
  };
  for (const Block& block : process.blocks) {
    for (ValueId id : block.operations) {
      for (ValueId operand : process[id].operands) use(operand, id);
      use(process[id].predicate, id);
    }
    use(block.terminator.condition, kNoValue);
  }
  return users;
}

/// A phi of a loop and the values that follow from it: sums and choices, all modulo 2^bits.
class Counter {
 public:
  Counter(Process& process, const Users& users, ValueId phi)
      : process_(process), users_(users), phi_(phi), bits_(process[phi].bits) {}

  bool can_turn() {
    if (!add_with_users(phi_) || comparisons_.empty()) return false;
    bool is_sound = std::all_of(values_.begin(), values_.end(), [&](ValueId id) { return can_turn(id); });
    return is_sound && find_bound();
  }

  /// Puts X - u in the place of every value u.
  void turn() {
    for (ValueId id : values_) {
      Operation& op = process_[id];
      if (op.kind == OpKind::kAdd) {
        if (!is_own(op.operands[0])) std::swap(op.operands[0], op.operands[1]);
        op.kind = OpKind::kSub;
      } else {
        for (size_t k = first_choice(op); k < op.operands.size(); ++k)
          if (is_zero(op.operands[k])) op.operands[k] = port_;
      }
    }
    for (ValueId id : comparisons_) {
      ValueId end = constant(-offset_, process_[id].operand_width);
      for (ValueId& operand : process_[id].operands)
        if (operand == bound_) operand = end;
    }
  }

 private:
  bool is_own(ValueId id) const { return values_.count(id); }
  bool is_zero(ValueId id) const {
    return process_[id].kind == OpKind::kConstant && process_[id].constant.isZero();
  }
  static size_t first_choice(const Operation& op) { return op.kind == OpKind::kSelect ? 1 : 0; }

  bool add_with_users(ValueId id) {
    if (!values_.insert(id).second) return true;
    return std::all_of(users_[id].begin(), users_[id].end(), [&](ValueId user) {
      if (user == kNoValue || process_[user].block != process_[phi_].block) return false;
      const Operation& op = process_[user];
      if (op.kind == OpKind::kCompare) return comparisons_.insert(user).second;
      return user == phi_ ||
             ((op.kind == OpKind::kAdd || op.kind == OpKind::kSelect) && add_with_users(user));
    });
  }

  bool can_turn(ValueId id) const {
    const Operation& op = process_[id];
    if (op.bits != bits_ || op.is_signed || is_own(op.predicate)) return false;
    if (op.kind == OpKind::kAdd) return is_own(op.operands[0]) != is_own(op.operands[1]);
    bool is_chosen = op.kind == OpKind::kSelect && is_own(op.operands[0]);
    return !is_chosen && std::all_of(op.operands.begin() + first_choice(op), op.operands.end(),
                                     [&](ValueId operand) { return is_own(operand) || is_zero(operand); });
  }

  /// The one value that all comparisons are with, if nobody else uses it and it is X + C.
  bool find_bound() {
    for (ValueId id : comparisons_) {
      const Operation& op = process_[id];
      bool is_equality = op.compare == CompareKind::kEq || op.compare == CompareKind::kNe;
      ValueId other = op.operands[is_own(op.operands[0]) ? 1 : 0];
      if (!is_equality || op.operand_width < bits_ || (bound_ != kNoValue && other != bound_)) return false;
      bound_ = other;
    }
    const Operation& bound = process_[bound_];
    if (bound.kind != OpKind::kAdd || bound.bits != bits_ || bound.is_signed) return false;
    for (ValueId user : users_[bound_])
      if (!comparisons_.count(user)) return false;
    const Operation& offset = process_[bound.operands[1]];
    if (offset.kind != OpKind::kConstant) return false;
    offset_ = offset.is_signed ? offset.constant.sextOrTrunc(bits_) : offset.constant.zextOrTrunc(bits_);
    port_ = bound.operands[0];
    if (process_[port_].kind == OpKind::kTrunc && process_[port_].bits >= bits_)
      port_ = process_[port_].operands[0];
    return process_[port_].kind == OpKind::kInput;
  }

  ValueId constant(const llvm::APInt& value, unsigned width) {
    Operation op;
    op.kind = OpKind::kConstant;
    op.type_width = width;
    op.constant = value.zextOrTrunc(width);
    op.bits = op.constant.getActiveBits();
    process_.operations.push_back(op);
    return process_.operations.size() - 1;
  }

  Process& process_;
  const Users& users_;
  ValueId phi_, bound_ = kNoValue, port_ = kNoValue;
  unsigned bits_;
  llvm::APInt offset_;
  std::set<ValueId> values_, comparisons_;
};

}  // namespace

void count_down(Process& process) {
  const Users users = users_of(process);
  for (const Block& block : process.blocks) {
    if (!block.is_loop) continue;
    for (ValueId id : block.operations) {
      if (process[id].kind != OpKind::kPhi) break;
      if (Counter counter(process, users, id); counter.can_turn()) counter.turn();
    }
  }
}

}  // namespace hlsc
