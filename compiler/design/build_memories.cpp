#include <llvm/Analysis/ConstantFolding.h>

#include "design/process_builder.h"

namespace hlsc {

using namespace llvm;

constexpr uint64_t kTinyDepth = 4;  ///< Arrays up to this depth become registers.
constexpr uint64_t kCombinationalRomBits =
    2048;  ///< Tables up to this size are logic, read in the same cycle.

MemoryObject& ProcessBuilder::object_at(Value* pointer, const Instruction& access) {
  auto known = objects_.find(pointer);
  if (known != objects_.end()) return known->second;
  Type* type = nullptr;
  if (auto* alloca = dyn_cast<AllocaInst>(pointer)) type = alloca->getAllocatedType();
  if (auto* global = dyn_cast<GlobalVariable>(pointer)) type = global->getValueType();
  if (!type)
    refuse(access,
           "this pointer may point to several objects; access each array by its own name with a subscript");
  MemoryObject& object = objects_[pointer];
  object.type = type;
  object.name = object_name(pointer);
  object.leaves = memory_leaves(layout_, type);
  for (const MemoryLeaf& leaf : object.leaves) {
    object.widths.push_back(leaf.bytes * 8);
    object.signedness.push_back(false);
    object.leaf_names.push_back(object.name + leaf.path);
  }
  read_partitions(pointer, object);
  return object;
}

std::string ProcessBuilder::object_name(Value* pointer) {
  if (auto* global = dyn_cast<GlobalVariable>(pointer)) {
    SmallVector<DIGlobalVariableExpression*, 1> debug;
    global->getDebugInfo(debug);
    return debug.empty() ? variable_part(global->getName().str()) : debug[0]->getVariable()->getName().str();
  }
  return variable_part(pointer->getName().str());
}

void ProcessBuilder::read_partitions(Value* pointer, MemoryObject& object) {
  for (const MemoryLeaf& leaf : object.leaves) object.partitions.emplace_back(leaf.dims.size());
  for (const ObjectDirective& entry : middle_.directives.of(pointer, "ARRAY_PARTITION"))
    for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
      if (entry.covers(object.leaves[leaf].byte_offset))
        partition(object.partitions[leaf], object.leaves[leaf], entry);
}

/// Dimensions of the leaf count from the first that lies inside the named array; those of arrays in structs
/// behind the named ones stay whole.
void ProcessBuilder::partition(std::vector<Partition>& partitions, const MemoryLeaf& leaf,
                               const ObjectDirective& entry) {
  const Directive& directive = entry.directive;
  std::string type = directive.text("type");
  Partition wanted;
  wanted.kind = directive.has("cyclic") || type == "cyclic" ? Partition::kCyclic
                : directive.has("block") || type == "block" ? Partition::kBlock
                                                            : Partition::kComplete;
  wanted.factor = directive.integer("factor", 2);
  size_t first = 0, dim = directive.integer("dim", 1);
  while (first < leaf.dims.size() && leaf.dims[first] * leaf.strides[first] > entry.bytes) ++first;
  for (size_t d = first; d < std::min(first + entry.dims, leaf.dims.size()); ++d)
    if (dim == 0 || dim == d - first + 1) partitions[d] = wanted;
}

bool ProcessBuilder::is_fully_partitioned(const MemoryObject& object, size_t leaf) {
  const std::vector<Partition>& partitions = object.partitions[leaf];
  return !partitions.empty() &&
         all_of(partitions, [](const Partition& p) { return p.kind == Partition::kComplete; });
}

uint64_t ProcessBuilder::bank_count(const Partition& partition, uint64_t size) {
  if (partition.kind == Partition::kNone) return 1;
  return partition.kind == Partition::kComplete ? size : std::min(partition.factor, size);
}

int ProcessBuilder::memory_of(MemoryObject& object, Value* pointer, size_t leaf, uint64_t bank) {
  auto known = object.memories.find({leaf, bank});
  if (known != object.memories.end()) return known->second;
  const MemoryLeaf& shape = object.leaves[leaf];
  Memory memory;
  bool registers = is_fully_partitioned(object, leaf);
  uint64_t banks = 1;
  for (size_t d = 0; d < shape.dims.size(); ++d) {
    uint64_t count = registers ? 1 : bank_count(object.partitions[leaf][d], shape.dims[d]);
    banks *= count;
    memory.depth *= (shape.dims[d] + count - 1) / count;
  }
  std::string bank_suffix = banks > 1 ? "_" + std::to_string(bank) : "";
  memory.name = names_.unique(object.leaf_names[leaf] + bank_suffix, "memory");
  memory.width = object.widths[leaf];
  memory.is_signed = object.signedness[leaf];
  if (!shape.dims.empty()) memory.claims = claims_of(pointer, shape);
  memory.is_aggregate = object.is_aggregate;
  if (object.is_aggregate) {
    memory.name = names_.unique(object.name);
    memory.width = low_bit(object, object.leaves.size());
    memory.is_signed = false;
  }
  if (object.argument < 0 && object.leaves.size() > 1 &&
      !middle_.directives.of(pointer, "AGGREGATE").empty()) {
    std::string& name = object.aggregates[bank];
    if (name.empty()) name = names_.unique(object.name + bank_suffix, "memory");
    memory.aggregate = name;
  }
  auto* global = dyn_cast<GlobalVariable>(pointer);
  if (global) memory.initial = initial_words(*global, object, leaf, bank, memory.depth);
  if (object.argument >= 0) {
    memory.kind = MemoryKind::kPort;
    memory.argument = object.argument;
    memory.llvm_argument = object.llvm_argument;
    memory.may_have_two_ports = may_have_two_ports(*cast<Argument>(pointer));
    memory.byte_offset = shape.byte_offset;
    if (!shape.strides.empty()) memory.stride = shape.strides.back();
  } else if (global && is_constant_table(*global)) {
    memory.kind = MemoryKind::kRom;
    memory.load_latency = memory.depth * memory.width <= kCombinationalRomBits ? 0 : 1;
  } else if (registers || memory.depth <= kTinyDepth) {
    memory.kind = MemoryKind::kRegisters;
    memory.load_latency = 0;
  }
  object.memories[{leaf, bank}] = process_.memories.size();
  process_.memories.push_back(memory);
  return process_.memories.size() - 1;
}

bool ProcessBuilder::may_have_two_ports(Argument& argument) const {
  auto says = [](const Directive& directive, const char* option, StringRef word) {
    return directive.has(word.lower()) || StringRef(directive.text(option)).equals_insensitive(word);
  };
  for (const char* kind : {"BIND_STORAGE", "RESOURCE"})
    for (const ObjectDirective& entry : middle_.directives.of(&argument, kind))
      if (says(entry.directive, "type", "ram_1p") || says(entry.directive, "core", "ram_1p")) return false;
  const Argument* outside = &argument;
  if (function_.getName() != program_.top)
    for (const User* user : function_.users())
      if (auto* call = dyn_cast<CallInst>(user))
        outside = dyn_cast<Argument>(call->getArgOperand(argument.getArgNo()));
  if (!outside) return false;
  auto ports = middle_.directives.ports.find(program_.top);
  if (ports == middle_.directives.ports.end()) return true;
  bool is_master = false, is_single = false;
  for (const PortDirective& entry : ports->second) {
    if (entry.port != outside->getName()) continue;
    is_master |= says(entry.directive, "mode", "m_axi");
    is_single |=
        says(entry.directive, "mode", "s_axilite") || says(entry.directive, "storage_type", "ram_1p");
  }
  return is_master || !is_single;
}

bool ProcessBuilder::is_constant_table(const GlobalVariable& global) { return global.isConstant(); }

std::vector<DependenceClaim> ProcessBuilder::claims_of(Value* pointer, const MemoryLeaf& leaf) {
  std::vector<DependenceClaim> claims;
  for (const ObjectDirective& entry : middle_.directives.of(pointer, "DEPENDENCE")) {
    if (entry.bytes && !entry.covers(leaf.byte_offset)) continue;  // 0: a parameter, which is the array.
    const Directive& directive = entry.directive;
    auto says = [&](const char* option, const char* word) {
      return directive.has(word) || StringRef(directive.text(option)).equals_insensitive(word);
    };
    bool is_false = says("dependent", "false");
    DependenceClaim claim;
    claim.number = directive.integer(kClaim, -1);
    claim.in_iteration = says("type", "intra");
    if (!is_false && (claim.in_iteration || !directive.has("distance")))
      continue;  // "true" alone frees nothing
    if (!claim.in_iteration && !says("type", "inter")) continue;
    claim.distance = is_false ? 0 : directive.integer("distance", 1);
    bool raw = says("direction", "raw"), war = says("direction", "war"), waw = says("direction", "waw");
    if (raw || war || waw) {
      claim.read_after_write = raw;
      claim.write_after_read = war;
      claim.write_after_write = waw;
    }
    claims.push_back(claim);
  }
  return claims;
}

std::vector<APInt> ProcessBuilder::initial_words(GlobalVariable& global, const MemoryObject& object,
                                                 size_t leaf, uint64_t bank, uint64_t depth) {
  const MemoryLeaf& shape = object.leaves[leaf];
  if (!global.hasInitializer()) return {};
  if (global.getInitializer()->isNullValue()) return {APInt(object.widths[leaf], 0)};
  std::vector<APInt> words(depth, APInt(object.widths[leaf], 0));
  uint64_t elements = 1;
  for (uint64_t size : shape.dims) elements *= size;
  for (uint64_t element = 0; element < elements; ++element) {
    uint64_t rest = element, offset = shape.byte_offset;
    std::vector<uint64_t> subscripts(shape.dims.size());
    for (size_t d = shape.dims.size(); d-- > 0;) {
      subscripts[d] = rest % shape.dims[d];
      rest /= shape.dims[d];
      offset += subscripts[d] * shape.strides[d];
    }
    auto [at_bank, address] = place(object, leaf, subscripts);
    if (at_bank != bank) continue;
    Constant* value = ConstantFoldLoadFromConst(global.getInitializer(),
                                                Type::getIntNTy(global.getContext(), shape.bytes * 8),
                                                APInt(64, offset), layout_);
    if (auto* integer = dyn_cast_or_null<ConstantInt>(value)) words[address] = integer->getValue();
  }
  return words;
}

std::pair<uint64_t, uint64_t> ProcessBuilder::place(const MemoryObject& object, size_t leaf,
                                                    const std::vector<uint64_t>& subscripts) {
  const MemoryLeaf& shape = object.leaves[leaf];
  bool registers = is_fully_partitioned(object, leaf);
  uint64_t bank = 0, address = 0;
  for (size_t d = 0; d < shape.dims.size(); ++d) {
    uint64_t count = registers ? 1 : bank_count(object.partitions[leaf][d], shape.dims[d]);
    uint64_t words = (shape.dims[d] + count - 1) / count;
    bool is_block = object.partitions[leaf][d].kind == Partition::kBlock;
    bank = bank * count + (is_block ? subscripts[d] / words : subscripts[d] % count);
    address = address * words + (is_block ? subscripts[d] % words : subscripts[d] / count);
  }
  return {bank, address};
}

}  // namespace hlsc
