#include "design/dead.h"

#include <vector>

namespace hlsc {
namespace {

class Liveness {
 public:
  explicit Liveness(const Process& process)
      : process_(process), is_live_(process.operations.size()), stores_(process.memories.size()) {
    for (const Block& block : process.blocks) {
      for (ValueId id : block.operations) find_root(id);
      mark(block.terminator.condition);
    }
    while (!work_.empty()) {
      ValueId id = work_.back();
      work_.pop_back();
      follow(process_[id]);
    }
  }

  bool is_live(ValueId id) const { return is_live_[id]; }

 private:
  void find_root(ValueId id) {
    const Operation& op = process_[id];
    bool is_inside = op.kind == OpKind::kStore && process_.memories[op.object].kind != MemoryKind::kPort;
    if (is_inside)
      stores_[op.object].push_back(id);
    else if (op.has_effect())
      mark(id);
  }

  void mark(ValueId id) {
    if (id == kNoValue || is_live_[id]) return;
    is_live_[id] = true;
    work_.push_back(id);
  }

  void follow(const Operation& op) {
    for (ValueId operand : op.operands) mark(operand);
    mark(op.predicate);
    if (op.kind == OpKind::kLoad)
      for (ValueId store : stores_[op.object]) mark(store);
  }

  const Process& process_;
  std::vector<bool> is_live_;
  std::vector<std::vector<ValueId>> stores_;  ///< By memory inside.
  std::vector<ValueId> work_;
};

}  // namespace

void remove_dead(Process& process) {
  Liveness liveness(process);
  for (Memory& memory : process.memories) memory.is_read = memory.is_written = false;
  for (Block& block : process.blocks) {
    std::erase_if(block.operations, [&](ValueId id) { return !liveness.is_live(id); });
    for (ValueId id : block.operations) {
      const Operation& op = process[id];
      if (op.kind == OpKind::kLoad) process.memories[op.object].is_read = true;
      if (op.kind == OpKind::kStore) process.memories[op.object].is_written = true;
    }
  }
}

}  // namespace hlsc
