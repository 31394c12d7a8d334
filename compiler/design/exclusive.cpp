#include "design/exclusive.h"

#include <algorithm>
#include <map>
#include <set>

namespace hlsc {
namespace {

/// What must hold for a predicate to be 1: conditions with their polarity.
using Literals = std::map<ValueId, bool>;

/// What predicates say of each other.
class Conditions {
 public:
  explicit Conditions(const Process& process) : process_(process) {}

  bool exclude(ValueId a, ValueId b) const {
    if (a == kNoValue || b == kNoValue) return false;
    Literals both, second;
    collect(a, true, both);
    collect(b, true, second);
    // Assume that both hold and look for a contradiction.
    for (auto [id, holds] : second)
      if (is_ruled_out(id, holds, both)) return true;
    Literals all = both;
    all.insert(second.begin(), second.end());
    for (auto [id, holds] : second)
      if (is_ruled_out(chosen(id, all), holds, both)) return true;
    for (auto [id, holds] : both)
      if (is_ruled_out(chosen(id, all), holds, second)) return true;
    return false;
  }

  /// Whether x and y differ where the predicate holds.
  bool tell_apart(ValueId predicate, ValueId x, ValueId y) const {
    Literals literals;
    collect(predicate, true, literals);
    return std::any_of(literals.begin(), literals.end(), [&](const auto& literal) {
      const Operation& op = process_[literal.first];
      if (op.kind != OpKind::kCompare || !is_equality(op, !literal.second)) return false;
      ValueId left = op.operands[0], right = op.operands[1];
      return (left == x && right == y) || (left == y && right == x);
    });
  }

 private:
  void collect(ValueId id, bool polarity, Literals& literals) const {
    const Operation& op = process_[id];
    bool is_conjunction = (polarity && op.kind == OpKind::kAnd) || (!polarity && op.kind == OpKind::kOr);
    if (op.type_width == 1 && is_conjunction) {
      for (ValueId operand : op.operands) collect(operand, polarity, literals);
      return;
    }
    if (op.type_width == 1 && op.kind == OpKind::kXor && is_one(op.operands[1])) {
      collect(op.operands[0], !polarity, literals);
      return;
    }
    literals[id] = polarity;
  }

  bool is_one(ValueId id) const {
    return process_[id].kind == OpKind::kConstant && process_[id].constant.isOne();
  }

  bool is_ruled_out(ValueId id, bool holds, const Literals& known) const {
    for (auto [other, other_holds] : known)
      if ((id == other && holds != other_holds) ||
          contradict(process_[id], holds, process_[other], other_holds))
        return true;
    return false;
  }

  /// What a select passes on, as far as the known conditions tell.
  ValueId chosen(ValueId id, const Literals& known) const {
    while (process_[id].kind == OpKind::kSelect) {
      const std::vector<ValueId>& operands = process_[id].operands;
      if (is_ruled_out(operands[0], true, known))
        id = operands[2];
      else if (is_ruled_out(operands[0], false, known))
        id = operands[1];
      else
        break;
    }
    return id;
  }

  /// Comparisons of one value that cannot both come out so.
  bool contradict(const Operation& a, bool a_holds, const Operation& b, bool b_holds) const {
    if (a.kind != OpKind::kCompare || b.kind != OpKind::kCompare || a.operands[0] != b.operands[0])
      return false;
    bool a_equal = is_equality(a, a_holds), b_equal = is_equality(b, b_holds);
    if (a.operands[1] == b.operands[1]) {
      bool a_differs = is_equality(a, !a_holds), b_differs = is_equality(b, !b_holds);
      return (a_equal && b_differs) || (a_differs && b_equal);
    }
    const Operation &x = process_[a.operands[1]], &y = process_[b.operands[1]];
    return a_equal && b_equal && x.kind == OpKind::kConstant && y.kind == OpKind::kConstant &&
           x.constant != y.constant;
  }
  static bool is_equality(const Operation& op, bool holds) {
    return op.compare == (holds ? CompareKind::kEq : CompareKind::kNe);
  }

  const Process& process_;
};

class AccessMerger {
 public:
  explicit AccessMerger(Process& process) : process_(process) {}

  void run() {
    for (size_t block = 0; block < process_.blocks.size(); ++block)
      while (merge_one(block)) {
      }
  }

 private:
  bool is_mergeable(const Operation& op) const {
    if (op.is_stream_access()) return !process_.streams[op.object].is_lock;
    return op.kind == OpKind::kStore && process_.memories[op.object].kind != MemoryKind::kRegisters;
  }

  bool merge_one(int block) {
    std::map<std::pair<bool, int>, ValueId> last;  ///< (is stream, object) -> latest access
    for (ValueId id : process_.blocks[block].operations) {
      const Operation& op = process_[id];
      if (!op.is_stream_access() && !op.is_memory_access()) continue;
      std::erase_if(last, [&](const auto& access) {
        return !access.first.first && process_.guards(op, access.first.second);
      });
      auto key = std::make_pair(op.is_stream_access(), op.object);
      auto before = last.find(key);
      if (before != last.end() && is_mergeable(op) &&
          !(op.kind == OpKind::kRead && depends_on(block, op.predicate, before->second)) &&
          process_[before->second].kind == op.kind &&
          Conditions(process_).exclude(process_[before->second].predicate, op.predicate)) {
        merge(block, before->second, id);
        return true;
      }
      last[key] = id;
    }
    return false;
  }

  /// The later access takes the earlier one's part.
  void merge(int block, ValueId first, ValueId second) {
    std::vector<ValueId>& operations = process_.blocks[block].operations;
    size_t at = std::find(operations.begin(), operations.end(), second) - operations.begin();
    auto insert = [&](OpKind kind, unsigned width, std::vector<ValueId> operands, const char* role) {
      Operation op;
      op.kind = kind;
      op.type_width = op.bits = width;
      op.operands = std::move(operands);
      op.block = block;
      op.location = process_[second].location;
      op.name = process_[second].name + "_" + role + std::to_string(count_++);
      process_.operations.push_back(op);
      operations.insert(operations.begin() + at++, process_.operations.size() - 1);
      return static_cast<ValueId>(process_.operations.size() - 1);
    };
    ValueId second_predicate = process_[second].predicate;
    if (process_[second].kind == OpKind::kRead) {
      // Results of the first are used before the second: the merged access stands where the first stood.
      at = std::find(operations.begin(), operations.end(), first) - operations.begin();
      if (!is_ready_before(block, second_predicate, first)) hoist(block, second_predicate, first);
      at = std::find(operations.begin(), operations.end(), first) - operations.begin();
      process_[first].predicate =
          insert(OpKind::kOr, 1, {process_[first].predicate, second_predicate}, "any");
      replace(second, first);
      operations.erase(std::find(operations.begin(), operations.end(), second));
      return;
    }
    for (size_t i = 0; i < process_[second].operands.size(); ++i) {
      ValueId a = process_[first].operands[i], b = process_[second].operands[i];
      if (a == b) continue;
      unsigned width = process_[b].type_width;
      ValueId chosen = insert(OpKind::kSelect, width, {second_predicate, b, a}, "of");
      process_[second].operands[i] = chosen;
    }
    process_[second].predicate = insert(OpKind::kOr, 1, {process_[first].predicate, second_predicate}, "any");
    operations.erase(std::find(operations.begin(), operations.end(), first));
  }

  bool is_ready_before(int block, ValueId value, ValueId user) const {
    if (process_[value].block != block) return true;
    const std::vector<ValueId>& operations = process_.blocks[block].operations;
    return std::find(operations.begin(), operations.end(), value) <
           std::find(operations.begin(), operations.end(), user);
  }

  /// Whether `value` needs the result of `source`, or an access whose place matters, in this block.
  bool depends_on(int block, ValueId value, ValueId source) const {
    if (value == source) return true;
    if (value == kNoValue || process_[value].block != block || process_[value].kind == OpKind::kPhi)
      return false;
    if (process_[value].is_stream_access() || process_[value].is_memory_access())
      return !is_ready_before(block, value, source);
    const std::vector<ValueId>& operands = process_[value].operands;
    return std::any_of(operands.begin(), operands.end(),
                       [&](ValueId operand) { return depends_on(block, operand, source); });
  }

  /// Moves what `value` needs, pure operations, in front of `user`.
  void hoist(int block, ValueId value, ValueId user) {
    if (process_[value].block != block || is_ready_before(block, value, user)) return;
    for (ValueId operand : process_[value].operands) hoist(block, operand, user);
    std::vector<ValueId>& operations = process_.blocks[block].operations;
    operations.erase(std::find(operations.begin(), operations.end(), value));
    operations.insert(std::find(operations.begin(), operations.end(), user), value);
  }

  void replace(ValueId old, ValueId by) {
    for (Operation& op : process_.operations) {
      for (ValueId& operand : op.operands)
        if (operand == old) operand = by;
      if (op.predicate == old) op.predicate = by;
    }
    for (Block& block : process_.blocks)
      if (block.terminator.condition == old) block.terminator.condition = by;
  }

  Process& process_;
  int count_ = 0;
};

}  // namespace

void merge_exclusive_accesses(Process& process) { AccessMerger(process).run(); }

bool are_set_apart(const Process& process, const Operation& a, const Operation& b) {
  const auto subscript = [&](const Operation& access) {
    ValueId id = access.operands[0];
    while (process[id].kind == OpKind::kZExt || process[id].kind == OpKind::kSExt)
      id = process[id].operands[0];
    return id;
  };
  const Conditions conditions(process);
  const auto says_so = [&](ValueId predicate) {
    return predicate != kNoValue && conditions.tell_apart(predicate, subscript(a), subscript(b));
  };
  return says_so(a.predicate) || says_so(b.predicate);
}

}  // namespace hlsc
