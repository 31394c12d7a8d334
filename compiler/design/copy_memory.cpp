#include "design/copy_memory.h"

#include <algorithm>

namespace hlsc {
namespace {

constexpr const char* kSuffix = "_copy";

/// Memories up to this size, which LUTs hold, may have several copies; others one, the second port that a
/// block RAM has.
constexpr uint64_t kSmallBits = 4096;

bool accesses(const Operation& op, OpKind kind, int memory) { return op.kind == kind && op.object == memory; }

std::string free_name(const Process& process, std::string name) {
  auto is_taken = [&] {
    return std::ranges::any_of(process.memories, [&](const Memory& other) { return other.name == name; }) ||
           std::ranges::any_of(process.operations,
                               [&](const Operation& other) { return other.name == name; });
  };
  while (is_taken()) name += kSuffix;
  return name;
}

}  // namespace

bool can_copy_memory(const Process& process, int memory) {
  const Memory& array = process.memories[memory];
  bool has_port =
      array.kind == MemoryKind::kRam || (array.kind == MemoryKind::kRom && array.load_latency > 0);
  if (!has_port || array.is_aggregate || !array.aggregate.empty()) return false;
  if (array.is_copied && array.depth * array.width > kSmallBits) return false;
  return std::ranges::any_of(process.blocks, [&](const Block& block) {
    return std::ranges::count_if(block.operations, [&](ValueId id) {
             return accesses(process[id], OpKind::kLoad, memory);
           }) > 1;
  });
}

void copy_memory(Process& process, int memory) {
  int copy = process.memories.size();
  process.memories[memory].is_copied = true;
  Memory made = process.memories[memory];
  made.name = free_name(process, made.name + kSuffix);
  process.memories.push_back(made);
  for (Block& block : process.blocks) {
    std::vector<ValueId> operations;
    int loads = 0;
    for (ValueId id : block.operations) {
      operations.push_back(id);
      if (accesses(process[id], OpKind::kLoad, memory) && loads++ % 2 == 1) process[id].object = copy;
      if (!accesses(process[id], OpKind::kStore, memory)) continue;
      Operation store = process[id];
      store.object = copy;
      store.name = free_name(process, store.name + kSuffix);
      operations.push_back(process.operations.size());
      process.operations.push_back(store);
    }
    block.operations = std::move(operations);
  }
}

}  // namespace hlsc
