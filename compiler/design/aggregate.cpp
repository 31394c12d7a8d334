#include "design/aggregate.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace hlsc {
namespace {

/// Loads or stores of one element, side by side: by member, the operation that touches it.
struct Access {
  bool is_store = false;
  ValueId address = kNoValue;
  ValueId predicate = kNoValue;
  std::map<size_t, ValueId> members;
  size_t word_before = 0;  ///< Of a store that lacks members: 1 + index of the load that has them.
};

/// The members of one aggregate.
class Aggregate {
 public:
  Aggregate(Process& process, const std::vector<int>& memories) : process_(process), memories_(memories) {}

  /// Joins them; returns the access that prevents it, or nothing.
  std::optional<SourceLocation> join() {
    std::vector<std::vector<Access>> by_block;
    for (const Block& block : process_.blocks) {
      by_block.push_back(accesses(block));
      for (size_t i = 0; i < by_block.back().size(); ++i)
        if (!complete(block, by_block.back(), i))
          return process_[by_block.back()[i].members.begin()->second].location;
    }
    make_word();
    for (size_t block = 0; block < process_.blocks.size(); ++block)
      rewrite(process_.blocks[block], by_block[block]);
    return {};
  }

 private:
  size_t member_of(const Operation& op) const {
    if (!op.is_memory_access()) return memories_.size();
    return std::find(memories_.begin(), memories_.end(), op.object) - memories_.begin();
  }

  /// Loads of an element join as long as nothing is stored; stores as long as nothing else happens.
  std::vector<Access> accesses(const Block& block) const {
    std::vector<Access> found;
    size_t since_store = 0;
    for (ValueId id : block.operations) {
      const Operation& op = process_[id];
      size_t member = member_of(op);
      if (member == memories_.size()) continue;
      bool is_store = op.kind == OpKind::kStore;
      auto joins = [&](const Access& access) {
        return access.is_store == is_store && access.address == op.operands[0] &&
               (!is_store || (access.predicate == op.predicate && !access.members.count(member)));
      };
      size_t first = is_store && !found.empty() ? std::max(since_store, found.size() - 1) : since_store;
      auto place = std::find_if(found.begin() + first, found.end(), joins);
      if (place == found.end()) {
        found.push_back({is_store, op.operands[0], op.predicate, {}, 0});
        place = found.end() - 1;
        if (is_store) since_store = found.size() - 1;
      }
      if (place->members.count(member))
        repeated_[id] = place->members[member];
      else
        place->members[member] = id;
    }
    return found;
  }

  /// Whether access `index` of a block is a load or has all members: as stored, as loaded before, or, where
  /// that costs no initiation interval, as loaded for it.
  bool complete(const Block& block, std::vector<Access>& accesses, size_t index) const {
    Access& store = accesses[index];
    if (!store.is_store || store.members.size() == memories_.size()) return true;
    for (size_t before = index; before-- > 0 && !accesses[before].is_store;)
      if (accesses[before].address == store.address) store.word_before = before + 1;
    return store.word_before > 0 || !block.is_loop;
  }

  void make_word() {
    const Memory& first = process_.memories[memories_[0]];
    Memory word = first;
    word.name = first.aggregate;
    word.is_signed = false;
    word.width = 0;
    for (int memory : memories_) {
      low_.push_back(word.width);
      word.width += process_.memories[memory].width;
      word.is_read |= process_.memories[memory].is_read;
      word.is_written |= process_.memories[memory].is_written;
    }
    word.initial = initial_words(word.width);
    word_ = process_.memories.size();
    process_.memories.push_back(word);
    for (int memory : memories_)
      process_.memories[memory].is_read = process_.memories[memory].is_written = false;
  }

  std::vector<llvm::APInt> initial_words(unsigned width) const {
    size_t count = 0;
    for (int memory : memories_) count = std::max(count, process_.memories[memory].initial.size());
    std::vector<llvm::APInt> words(count, llvm::APInt(width, 0));
    for (size_t member = 0; member < memories_.size(); ++member) {
      const Memory& memory = process_.memories[memories_[member]];
      for (size_t i = 0; i < count && !memory.initial.empty(); ++i)
        words[i].insertBits(memory.initial[memory.initial.size() == 1 ? 0 : i].zextOrTrunc(memory.width),
                            low_[member]);
    }
    return words;
  }

  void rewrite(Block& block, const std::vector<Access>& accesses) {
    std::map<ValueId, size_t> first, last;  ///< The operation at which an access happens -> its index.
    std::vector<ValueId> words(accesses.size(), kNoValue);
    for (size_t i = 0; i < accesses.size(); ++i) {
      auto order = [&](const auto& a, const auto& b) {
        return place(block, a.second) < place(block, b.second);
      };
      const auto& members = accesses[i].members;
      if (accesses[i].is_store)
        last[std::max_element(members.begin(), members.end(), order)->second] = i;
      else
        first[std::min_element(members.begin(), members.end(), order)->second] = i;
    }
    std::vector<ValueId> old;
    old.swap(block.operations);
    for (ValueId id : old) {
      if (auto load = first.find(id); load != first.end()) words[load->second] = load_word(block, id);
      bool is_joined = member_of(process_[id]) < memories_.size();
      if (auto store = last.find(id); store != last.end())
        store_word(block, accesses[store->second], id, words);
      else if (is_joined && process_[id].kind == OpKind::kStore)
        continue;
      else if (is_joined)
        take_member(block, id, word_of(id, accesses, words));
      block.operations.push_back(id);
    }
  }

  static size_t place(const Block& block, ValueId id) {
    return std::find(block.operations.begin(), block.operations.end(), id) - block.operations.begin();
  }

  ValueId word_of(ValueId id, const std::vector<Access>& accesses, const std::vector<ValueId>& words) const {
    auto repeated = repeated_.find(id);
    ValueId first = repeated == repeated_.end() ? id : repeated->second;
    for (size_t i = 0; i < accesses.size(); ++i)
      for (auto [member, load] : accesses[i].members)
        if (load == first) return words[i];
    return kNoValue;
  }

  /// A new operation in front of `near`, with its location.
  ValueId add(Block& block, ValueId near, OpKind kind, unsigned width, std::vector<ValueId> operands,
              const std::string& suffix) {
    Operation op;
    op.kind = kind;
    op.type_width = op.bits = width;
    op.operands = std::move(operands);
    op.block = process_[near].block;
    op.location = process_[near].location;
    op.name = process_[near].name + suffix;
    process_.operations.push_back(op);
    block.operations.push_back(process_.operations.size() - 1);
    return block.operations.back();
  }

  ValueId load_word(Block& block, ValueId near) {
    ValueId word = add(block, near, OpKind::kLoad, process_.memories[word_].width,
                       {process_[near].operands[0]}, "_element");
    process_[word].object = word_;
    return word;
  }

  /// Turns the load of a member into an extension of its slice of the word.
  void take_member(Block& block, ValueId id, ValueId word) {
    size_t member = member_of(process_[id]);
    const Memory memory = process_.memories[process_[id].object];
    ValueId part = slice(block, id, word, member);
    Operation& load = process_[id];
    load.kind = memory.is_signed ? OpKind::kSExt : OpKind::kZExt;
    load.operands = {part};
    load.operand_width = memory.width;
  }

  ValueId slice(Block& block, ValueId near, ValueId word, size_t member) {
    unsigned width = process_.memories[memories_[member]].width, whole = process_[word].type_width;
    std::string suffix = "_" + std::to_string(member);
    ValueId shifted = word;
    if (low_[member]) {
      shifted =
          add(block, near, OpKind::kLShr, whole, {word, constant(whole, low_[member])}, suffix + "_above");
      process_[shifted].bits = whole - low_[member];
    }
    return width == whole ? shifted : add(block, near, OpKind::kTrunc, width, {shifted}, suffix + "_part");
  }

  ValueId constant(unsigned width, unsigned value) {
    Operation op;
    op.type_width = width;
    op.constant = llvm::APInt(width, value);
    op.bits = std::max(1u, op.constant.getActiveBits());
    process_.operations.push_back(op);
    return process_.operations.size() - 1;
  }

  void store_word(Block& block, const Access& store, ValueId id, const std::vector<ValueId>& words) {
    ValueId before = store.word_before ? words[store.word_before - 1] : kNoValue;
    if (before == kNoValue && store.members.size() < memories_.size()) before = load_word(block, id);
    std::vector<ValueId> parts;
    for (size_t member = 0; member < memories_.size(); ++member) {
      auto stored = store.members.find(member);
      unsigned width = process_.memories[memories_[member]].width;
      if (stored == store.members.end())
        parts.push_back(slice(block, id, before, member));
      else
        parts.push_back(add(block, id, OpKind::kTrunc, width, {process_[stored->second].operands[1]},
                            "_" + std::to_string(member)));
    }
    ValueId word = add(block, id, OpKind::kConcat, process_.memories[word_].width, parts, "_word");
    process_[id].object = word_;
    process_[id].operands[1] = word;
  }

  Process& process_;
  std::vector<int> memories_;
  std::vector<unsigned> low_;  ///< By member: its place in the word.
  int word_ = -1;
  mutable std::map<ValueId, ValueId> repeated_;  ///< A second load of a member -> the first one.
};

}  // namespace

void join_aggregates(Process& process, Diagnostics& diagnostics) {
  std::map<std::string, std::vector<int>> aggregates;
  for (size_t i = 0; i < process.memories.size(); ++i) {
    const Memory& memory = process.memories[i];
    if (!memory.aggregate.empty() && memory.kind == MemoryKind::kRam && memory.is_read)
      aggregates[memory.aggregate].push_back(i);
  }
  for (auto& [name, members] : aggregates) {
    if (members.size() < 2) continue;
    if (std::optional<SourceLocation> obstacle = Aggregate(process, members).join())
      diagnostics.warn(*obstacle, "AGGREGATE of '" + name +
                                      "' has no effect: this stores a part of an element in a loop; "
                                      "store the whole struct, or load it in the same iteration before");
  }
}

}  // namespace hlsc
