#include "design/narrow.h"

#include <algorithm>
#include <set>

namespace hlsc {
namespace {

/// How many low bits carry a value, and how the rest follows from them.
struct Form {
  unsigned bits = 1;
  bool is_signed = false;
};

/// The least form that holds all values of both.
Form joined(Form a, Form b) {
  if (a.is_signed == b.is_signed) return {std::max(a.bits, b.bits), a.is_signed};
  if (a.is_signed) return {std::max(a.bits, b.bits + 1), true};
  return {std::max(a.bits + 1, b.bits), true};
}

class Narrower {
 public:
  explicit Narrower(Process& process) : process_(process) {}

  void run() {
    for (bool changed = true; changed;) {
      changed = shrink_to_ranges();
      changed |= shrink_memories();
    }
    find_demand();
    for (size_t id = 0; id < process_.operations.size(); ++id) cut_to_demand(id);
    cut_memories_to_demand();
    remove_dead();
    shrink_memories();
  }

 private:
  Form form(ValueId id) const { return {process_[id].bits, process_[id].is_signed}; }
  Form operand(const Operation& op, size_t index) const { return form(op.operands[index]); }

  bool shrink_to_ranges() {
    bool changed = false;
    for (size_t id = 0; id < process_.operations.size(); ++id) {
      Operation& op = process_[id];
      if (!op.has_result() || op.kind == OpKind::kConstant || op.kind == OpKind::kInput) continue;
      Form range = result_form(op);
      if (range.bits >= op.bits) continue;
      op.bits = std::max(1u, range.bits);
      op.is_signed = range.is_signed;
      changed = true;
    }
    return changed;
  }

  bool constant_operand(const Operation& op, size_t index, uint64_t& value) const {
    const Operation& operand = process_[op.operands[index]];
    if (operand.kind != OpKind::kConstant || operand.constant.getActiveBits() > 63) return false;
    value = operand.constant.getZExtValue();
    return true;
  }

  Form result_form(const Operation& op) const {
    Form full{op.type_width, false};
    uint64_t constant = 0;
    switch (op.kind) {
      case OpKind::kAdd: {
        Form sum = joined(operand(op, 0), operand(op, 1));
        return {sum.bits + 1, sum.is_signed};
      }
      case OpKind::kSub: {
        Form difference = joined(operand(op, 0), operand(op, 1));
        return {difference.bits + 1, true};
      }
      case OpKind::kMul: {
        Form a = operand(op, 0), b = operand(op, 1);
        return {a.bits + b.bits, a.is_signed || b.is_signed};
      }
      case OpKind::kUDiv:
        return operand(op, 0).is_signed ? full : operand(op, 0);
      case OpKind::kURem:
        if (operand(op, 1).is_signed) return full;
        return operand(op, 0).is_signed ? operand(op, 1)
                                        : Form{std::min(operand(op, 0).bits, operand(op, 1).bits), false};
      case OpKind::kAnd: {
        Form a = operand(op, 0), b = operand(op, 1);
        if (!a.is_signed && !b.is_signed) return {std::min(a.bits, b.bits), false};
        if (!a.is_signed) return a;
        if (!b.is_signed) return b;
        return joined(a, b);
      }
      case OpKind::kOr:
      case OpKind::kXor:
        return joined(operand(op, 0), operand(op, 1));
      case OpKind::kShl:
        if (!constant_operand(op, 1, constant)) return full;
        return {operand(op, 0).bits + static_cast<unsigned>(constant), operand(op, 0).is_signed};
      case OpKind::kLShr:
        if (operand(op, 0).is_signed)
          return constant_operand(op, 1, constant) && constant < op.type_width
                     ? Form{op.type_width - static_cast<unsigned>(constant), false}
                     : full;
        if (!constant_operand(op, 1, constant)) return operand(op, 0);
        return {operand(op, 0).bits > constant ? operand(op, 0).bits - static_cast<unsigned>(constant) : 1,
                false};
      case OpKind::kAShr:
        if (!constant_operand(op, 1, constant)) return operand(op, 0);
        return {operand(op, 0).bits > constant ? operand(op, 0).bits - static_cast<unsigned>(constant) : 1,
                operand(op, 0).is_signed};
      case OpKind::kSelect:
        return joined(operand(op, 1), operand(op, 2));
      case OpKind::kPhi:
        return form_of_choices(op);
      case OpKind::kZExt:
        return operand(op, 0).is_signed ? Form{process_[op.operands[0]].type_width, false} : operand(op, 0);
      case OpKind::kSExt: {
        const Operation& source = process_[op.operands[0]];
        if (!source.is_signed && source.bits == source.type_width) return {source.bits, true};
        return form(op.operands[0]);
      }
      case OpKind::kTrunc:
        return operand(op, 0).bits <= op.type_width ? operand(op, 0) : full;
      case OpKind::kCompare:
        return {1, false};
      case OpKind::kLoad:
        return {process_.memories[op.object].width, process_.memories[op.object].is_signed};
      default:
        return full;
    }
  }

  /// A phi holds one of the values that it, and the selects and phis among its operands, choose from. These
  /// may lead back to the phi, which adds nothing: the least value so far is as wide as the values compared.
  Form form_of_choices(const Operation& phi) const {
    std::set<ValueId> seen;
    std::vector<ValueId> open = phi.operands;
    Form all{0, false};
    while (!open.empty()) {
      ValueId id = open.back();
      open.pop_back();
      if (!seen.insert(id).second) continue;
      const Operation& choice = process_[id];
      if (choice.kind == OpKind::kPhi)
        open.insert(open.end(), choice.operands.begin(), choice.operands.end());
      else if (choice.kind == OpKind::kSelect)
        open.insert(open.end(), choice.operands.begin() + 1, choice.operands.end());
      else
        all = all.bits ? joined(all, form(id)) : form(id);
    }
    return all.bits ? all : Form{phi.type_width, false};
  }

  /// A memory is as wide as the widest value stored in it; those that start undefined need no more.
  bool shrink_memories() {
    bool changed = false;
    for (size_t index = 0; index < process_.memories.size(); ++index) {
      Memory& memory = process_.memories[index];
      if (memory.kind == MemoryKind::kPort) continue;
      std::vector<Form> contents;
      for (const llvm::APInt& word : memory.initial) {
        unsigned unsigned_bits = std::max(1u, word.getActiveBits()), signed_bits = word.getSignificantBits();
        contents.push_back(signed_bits < unsigned_bits ? Form{signed_bits, true}
                                                       : Form{unsigned_bits, false});
      }
      for (const Block& block : process_.blocks)
        for (ValueId id : block.operations)
          if (process_[id].kind == OpKind::kStore && process_[id].object == static_cast<int>(index))
            contents.push_back(form(process_[id].operands[1]));
      if (contents.empty()) continue;
      Form all = contents[0];
      for (Form one : contents) all = joined(all, one);
      if (all.bits >= memory.width) continue;
      memory.width = all.bits;
      memory.is_signed = all.is_signed;
      changed = true;
    }
    return changed;
  }

  // --- Demanded bits ---

  void find_demand() {
    demand_.assign(process_.operations.size(), 0);
    memory_demand_.assign(process_.memories.size(), 1);
    stored_.assign(process_.memories.size(), {});
    for (const Block& block : process_.blocks) {
      for (ValueId id : block.operations) {
        const Operation& op = process_[id];
        if (!op.has_effect()) continue;
        if (op.predicate != kNoValue) want(op.predicate, 1);
        if (op.kind == OpKind::kStore) {
          want(op.operands[0], address_bits(process_.memories[op.object].depth));
          stored_[op.object].push_back(op.operands[1]);
          bool is_port = process_.memories[op.object].kind == MemoryKind::kPort;
          want(op.operands[1], is_port ? process_.memories[op.object].width : 1);
        } else if (op.kind == OpKind::kWrite) {
          want(op.operands[0], process_.streams[op.object].width);
        } else if (op.kind == OpKind::kOutput) {
          want(op.operands[0], process_.scalars[op.object].width);
        }
      }
      if (block.terminator.condition != kNoValue)
        want(block.terminator.condition, process_[block.terminator.condition].type_width);
    }
    while (!work_.empty()) {
      ValueId id = *work_.begin();
      work_.erase(work_.begin());
      spread(id);
    }
  }

  void want(ValueId id, unsigned bits) {
    bits = std::min(bits, process_[id].type_width);
    if (bits <= demand_[id]) return;
    demand_[id] = bits;
    work_.insert(id);
  }
  /// A word keeps no more bits than some load asks for, also where it is only loaded to be stored again.
  void want_of_memory(int memory, unsigned bits) {
    if (bits <= memory_demand_[memory]) return;
    memory_demand_[memory] = bits;
    for (ValueId data : stored_[memory]) want(data, bits);
  }
  void want_all(ValueId id) { want(id, process_[id].type_width); }

  void spread(ValueId id) {
    const Operation& op = process_[id];
    // Bits above the representation are copies; they cost the operands nothing.
    unsigned bits = std::min(demand_[id], op.bits);
    if (op.predicate != kNoValue) want(op.predicate, 1);
    uint64_t constant = 0;
    switch (op.kind) {
      case OpKind::kAdd:
      case OpKind::kSub:
      case OpKind::kMul:
      case OpKind::kAnd:
      case OpKind::kOr:
      case OpKind::kXor:
      case OpKind::kPhi:
      case OpKind::kTrunc:
      case OpKind::kZExt:
      case OpKind::kSExt:
        for (ValueId operand : op.operands) want(operand, bits);
        break;
      case OpKind::kShl:
        want_all(op.operands[1]);
        want(op.operands[0],
             constant_operand(op, 1, constant) ? (bits > constant ? bits - constant : 1) : bits);
        break;
      case OpKind::kLShr:
      case OpKind::kAShr:
        want_all(op.operands[1]);
        if (constant_operand(op, 1, constant))
          want(op.operands[0], bits + constant);
        else
          want_all(op.operands[0]);
        break;
      case OpKind::kSelect:
        want(op.operands[0], 1);
        want(op.operands[1], bits);
        want(op.operands[2], bits);
        break;
      case OpKind::kLoad:
        want(op.operands[0], address_bits(process_.memories[op.object].depth));
        want_of_memory(op.object, bits);
        break;
      default:
        for (ValueId operand : op.operands) want_all(operand);
    }
  }

  void cut_to_demand(ValueId id) {
    Operation& op = process_[id];
    if (op.kind == OpKind::kInput || op.kind == OpKind::kConstant || op.kind == OpKind::kRead ||
        !op.has_result())
      return;
    if (demand_[id] == 0 || demand_[id] >= op.bits) return;
    op.bits = demand_[id];
    op.is_signed = false;  // Nobody looks above.
  }

  void cut_memories_to_demand() {
    for (size_t index = 0; index < process_.memories.size(); ++index) {
      Memory& memory = process_.memories[index];
      if (memory.kind == MemoryKind::kPort || memory_demand_[index] >= memory.width) continue;
      memory.width = memory_demand_[index];
      memory.is_signed = false;  // Nobody looks above.
    }
  }

  void remove_dead() {
    for (Block& block : process_.blocks) {
      auto dead = [&](ValueId id) { return demand_[id] == 0 && !process_[id].has_effect(); };
      block.operations.erase(std::remove_if(block.operations.begin(), block.operations.end(), dead),
                             block.operations.end());
    }
  }

  Process& process_;
  std::vector<unsigned> demand_;              ///< Low bits that somebody uses, by operation.
  std::vector<unsigned> memory_demand_;       ///< By memory.
  std::vector<std::vector<ValueId>> stored_;  ///< Data of the stores, by memory.
  std::set<ValueId> work_;
};

}  // namespace

void narrow(Process& process) { Narrower(process).run(); }

}  // namespace hlsc
