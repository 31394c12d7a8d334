#include "design/share_loads.h"

#include <algorithm>
#include <map>

namespace hlsc {
namespace {

/// A representation that holds what either load may be known to hold.
void widen(Operation& kept, const Operation& other) {
  if (kept.is_signed == other.is_signed) {
    kept.bits = std::max(kept.bits, other.bits);
  } else {
    kept.bits = kept.type_width;
    kept.is_signed = false;
  }
}

void share_in(Process& process, const Block& block, std::vector<ValueId>& stands_for) {
  std::map<std::pair<int, ValueId>, ValueId> words;  ///< By memory and address: the load, or what was stored.
  for (ValueId id : block.operations) {
    const Operation& op = process[id];
    std::erase_if(words, [&](const auto& word) { return process.guards(op, word.first.first); });
    bool is_store = op.kind == OpKind::kStore;
    if (is_store) std::erase_if(words, [&](const auto& word) { return word.first.first == op.object; });
    if (!is_store && op.kind != OpKind::kLoad) continue;
    if (process.memories[op.object].kind == MemoryKind::kRegisters) continue;
    if (is_store && op.predicate == kNoValue) words[{op.object, op.operands[0]}] = op.operands[1];
    if (is_store) continue;
    auto [word, is_new] = words.emplace(std::make_pair(op.object, op.operands[0]), id);
    if (is_new || process[word->second].type_width != op.type_width) continue;
    if (process[word->second].kind == OpKind::kLoad) widen(process[word->second], op);
    stands_for[id] = word->second;
  }
}

}  // namespace

void share_loads(Process& process) {
  std::vector<ValueId> stands_for(process.operations.size());
  for (size_t id = 0; id < stands_for.size(); ++id) stands_for[id] = id;
  for (const Block& block : process.blocks) share_in(process, block, stands_for);
  auto replace = [&](ValueId& id) {
    while (id != kNoValue && stands_for[id] != id) id = stands_for[id];
  };
  for (Operation& op : process.operations) {
    for (ValueId& operand : op.operands) replace(operand);
    replace(op.predicate);
  }
  for (Block& block : process.blocks) replace(block.terminator.condition);
}

}  // namespace hlsc
