#include "design/shared_phis.h"

#include <algorithm>
#include <set>

namespace hlsc {
namespace {

/// Whether a phi of one loop steps as a phi of another does, together with the phis that it depends on.
class StepComparison {
 public:
  StepComparison(const Process& process, int early, int late)
      : process_(process), early_(early), late_(late) {}

  /// Pairs are taken for alike until a difference is found.
  bool alike(ValueId early, ValueId late) {
    const Operation &a = process_[early], &b = process_[late];
    if (a.kind == OpKind::kConstant && b.kind == OpKind::kConstant)
      return a.is_signed == b.is_signed && a.type_width == b.type_width && a.constant == b.constant;
    if (a.block != early_ || b.block != late_) return early == late;
    if (!same_operation(a, b)) return false;
    if (!pairs_.insert({early, late}).second) return true;
    if (a.kind == OpKind::kPhi) return alike(next(early), next(late));
    for (size_t k = 0; k < a.operands.size(); ++k)
      if (!alike(a.operands[k], b.operands[k])) return false;
    return true;
  }

  /// The phis that were compared; late ones with early ones.
  std::map<ValueId, ValueId> phis() const {
    std::map<ValueId, ValueId> found;
    for (auto [early, late] : pairs_)
      if (process_[early].kind == OpKind::kPhi) found.emplace(late, early);
    return found;
  }

 private:
  static bool same_operation(const Operation& a, const Operation& b) {
    bool is_logic = a.has_result() && !a.is_memory_access() && !a.is_stream_access() &&
                    a.kind != OpKind::kEmpty && a.kind != OpKind::kFull;
    return is_logic && a.kind == b.kind && a.bits == b.bits && a.is_signed == b.is_signed &&
           a.type_width == b.type_width && a.operand_width == b.operand_width && a.compare == b.compare &&
           (a.kind == OpKind::kPhi || a.operands.size() == b.operands.size());
  }

  ValueId next(ValueId phi) const {
    const Operation& op = process_[phi];
    const std::vector<int>& predecessors = process_.blocks[op.block].predecessors;
    return op.operands[std::find(predecessors.begin(), predecessors.end(), op.block) - predecessors.begin()];
  }

  const Process& process_;
  const int early_, late_;
  std::set<std::pair<ValueId, ValueId>> pairs_;
};

class Sharing {
 public:
  explicit Sharing(const Process& process) : process_(process) {}

  std::map<ValueId, ValueId> run() {
    for (size_t late = 0; late < process_.blocks.size(); ++late)
      for (size_t early = 0; early < late; ++early)
        if (process_.blocks[early].is_loop && process_.blocks[late].is_loop) share(early, late);
    return registers_;
  }

 private:
  void share(int early, int late) {
    for (ValueId b : phis(late))
      for (ValueId a : phis(early)) {
        if (registers_.count(b)) continue;
        StepComparison comparison(process_, early, late);
        if (comparison.alike(a, b)) take(comparison.phis(), late);
      }
  }

  std::vector<ValueId> phis(int block) const {
    std::vector<ValueId> found;
    for (ValueId id : process_.blocks[block].operations)
      if (process_[id].kind == OpKind::kPhi) found.push_back(id);
    return found;
  }

  ValueId register_of(ValueId phi) const {
    auto shared = registers_.find(phi);
    return shared == registers_.end() ? phi : shared->second;
  }

  /// All of these, or none where two phis of the late loop would have one register.
  void take(const std::map<ValueId, ValueId>& pairs, int late) {
    std::map<ValueId, ValueId> wanted = registers_;
    for (auto [b, a] : pairs) {
      if (registers_.count(b) && registers_.at(b) != register_of(a)) return;
      wanted[b] = register_of(a);
    }
    std::set<ValueId> used;
    for (ValueId phi : phis(late)) {
      auto shared = wanted.find(phi);
      if (!used.insert(shared == wanted.end() ? phi : shared->second).second) return;
    }
    registers_ = std::move(wanted);
  }

  const Process& process_;
  std::map<ValueId, ValueId> registers_;
};

}  // namespace

std::map<ValueId, ValueId> shared_phis(const Process& process) { return Sharing(process).run(); }

}  // namespace hlsc
