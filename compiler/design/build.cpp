#include "design/build.h"

#include <llvm/ADT/StringExtras.h>
#include <llvm/Analysis/AssumptionCache.h>
#include <llvm/Analysis/ConstantFolding.h>
#include <llvm/Analysis/TargetLibraryInfo.h>
#include <llvm/IR/PatternMatch.h>

#include <numeric>
#include <optional>

#include "design/names.h"
#include "middle/array_access.h"
#include "middle/llvm_headers.h"
#include "middle/primitives.h"
#include "middle/source_location.h"

namespace hlsc {
namespace {

using namespace llvm;

constexpr uint64_t kTinyDepth = 4;  ///< Arrays up to this depth become registers.
constexpr uint64_t kCombinationalRomBits =
    2048;  ///< Tables up to this size are logic, read in the same cycle.

/// An array dimension split over banks.
struct Partition {
  enum Kind { kNone, kComplete, kCyclic, kBlock } kind = kNone;
  uint64_t factor = 1;
};

/// Something in memory: local array, static, or what a pointer parameter points to.
struct MemoryObject {
  std::string name;
  Type* type = nullptr;  ///< Of allocas and globals.
  std::vector<MemoryLeaf> leaves;
  std::vector<unsigned> widths;  ///< Of each leaf.
  std::vector<bool> signedness;
  std::vector<std::string> leaf_names;
  int argument = -1;
  int llvm_argument = -1;
  bool is_aggregate =
      false;  ///< AGGREGATE on an array of structs outside that is only read: one word an element.
  bool is_scalar_port = false;                          ///< Leaves are scalar ports, not memories.
  std::vector<Partition> partitions;                    ///< By dimension.
  std::map<std::pair<size_t, uint64_t>, int> memories;  ///< (leaf, bank) -> index in Process::memories.
  std::map<size_t, int> inputs, outputs;                ///< leaf -> index in Process::scalars.
};

/// Where a load or store goes.
struct Address {
  MemoryObject* object = nullptr;
  size_t leaf = 0;
  std::vector<ValueId> subscripts;  ///< One per dimension of the leaf, or a single linear one.
  bool is_linear = false;
};

class ProcessBuilder {
 public:
  ProcessBuilder(const Program& program, const MiddleResult& middle, const std::string& function,
                 const std::string& module_name)
      : middle_(middle),
        function_(*program.module->getFunction(function)),
        layout_(program.module->getDataLayout()),
        library_info_(Triple(program.module->getTargetTriple())),
        library_(library_info_),
        assumptions_(function_),
        dominators_(function_),
        loops_(dominators_),
        evolution_(function_, library_, assumptions_, dominators_, loops_) {
    auto known = program.functions.find(function);
    if (known == program.functions.end())
      throw CompileError("the parameters of '" + module_name +
                         "' have no hardware form; use integers, ap types, structs, arrays of known size and "
                         "hls::stream references");
    info_ = &known->second;
    process_.name = names_.unique(module_name);
    process_.source_name = info_->qualified;
    process_.location = info_->location;
  }

  Region build_region(const std::vector<Process>& processes) {
    Region region;
    region_ = &region;
    region_processes_ = &processes;
    region.head = build();
    for (const RegionChannel& channel : region.channels)
      if (channel.reader < 0)
        throw CompileError(
            info_->location,
            "array '" + channel.name + "' is written by a process and read by none; remove it or read it");
    region.head.streams.clear();  // They pass the head by.
    return region;
  }

  Process build() {
    read_parameters();
    find_scalar_port_uses();
    ReversePostOrderTraversal<Function*> order(&function_);
    for (BasicBlock* block : order) {
      block_ids_[block] = process_.blocks.size();
      process_.blocks.emplace_back();
    }
    for (BasicBlock* block : order) build_block(*block);
    for (BasicBlock* block : order) finish_block(*block);
    return std::move(process_);
  }

 private:
  [[noreturn]] void refuse(const Instruction& instruction, const std::string& sentence) {
    throw CompileError(nearest_location(instruction), sentence);
  }

  // --- Parameters ---

  void read_parameters() {
    auto argument = function_.arg_begin();
    if (argument != function_.arg_end() && argument->hasStructRetAttr()) add_result_object(*argument++);
    for (size_t index = 0; index < info_->parameters.size(); ++index) {
      const Parameter& parameter = info_->parameters[index];
      bool first = true;
      while (argument != function_.arg_end() &&
             (first || argument->getName().starts_with(parameter.name + ".coerce"))) {
        if (argument->getName().starts_with(parameter.name) || parameter.name.empty())
          read_parameter(*argument, parameter, index);
        else
          break;
        first = false;
        ++argument;
      }
    }
    if (!function_.getReturnType()->isVoidTy()) {
      bool is_lone = info_->result.leaves.size() == 1;
      unsigned width = is_lone ? info_->result.leaves[0].width : returned_bits(function_.getReturnType());
      result_port_ = process_.scalars.size();
      process_.scalars.push_back({"ap_return", width, false, true, true, -1, 0, -1, -1});
    }
  }

  void read_parameter(Argument& argument, const Parameter& parameter, int index) {
    if (!parameter.streams.empty()) {
      for (const StreamMember& member : parameter.streams) {
        streams_[{&argument, member.byte_offset}] = process_.streams.size();
        Stream stream;
        stream.name = names_.unique(parameter.name + member.suffix, "stream");
        stream.width = member.layout.width();
        stream.is_input = true;
        stream.argument = index;
        stream.index = member.index;
        stream.byte_offset = member.byte_offset;
        stream.llvm_argument = argument.getArgNo();
        process_.streams.push_back(stream);
      }
    } else if (argument.getType()->isPointerTy()) {
      add_parameter_object(argument, parameter, index);
    } else {
      add_scalar_input(argument, parameter, index);
    }
  }

  void add_scalar_input(Argument& argument, const Parameter& parameter, int index) {
    bool lone = parameter.layout.leaves.size() == 1;
    unsigned type_width = argument.getType()->getIntegerBitWidth();
    ScalarPort port;
    unsigned width = lone ? parameter.layout.leaves[0].width : type_width;
    bool is_second_half = argument.getName().ends_with(".coerce1");
    bool is_split = lone && width > type_width;
    std::string half = is_second_half ? "_1" : "_0";
    port.name = names_.unique(lone && !is_split ? parameter.name : parameter.name + half);
    port.width = is_second_half && lone ? width - 64 : std::min(width, type_width);
    port.is_signed = lone && !is_split && parameter.layout.leaves[0].is_signed;
    port.argument = index;
    port.llvm_argument = argument.getArgNo();
    if (is_second_half) port.byte_offset = 8;
    values_[&argument] = add_input(port, type_width);
  }

  ValueId add_input(const ScalarPort& port, unsigned type_width) {
    Operation input;
    input.kind = OpKind::kInput;
    input.type_width = type_width;
    input.bits = port.width;
    input.is_signed = port.is_signed;
    input.object = process_.scalars.size();
    input.name = port.name;
    process_.scalars.push_back(port);
    process_.operations.push_back(input);
    return process_.operations.size() - 1;
  }

  void add_layout(MemoryObject& object, const TypeLayout& layout, const std::vector<uint64_t>& dims) {
    std::vector<uint64_t> strides(dims.size(), layout.bytes);
    for (size_t d = dims.size(); d-- > 1;) strides[d - 1] = strides[d] * dims[d];
    for (const Leaf& leaf : layout.leaves) {
      object.leaves.push_back({leaf.name, leaf.byte_offset, leaf.bytes, dims, strides});
      object.widths.push_back(leaf.width);
      object.signedness.push_back(leaf.is_signed);
      object.leaf_names.push_back(leaf.name.empty() ? object.name : object.name + "_" + leaf.name);
    }
  }

  void add_result_object(Argument& argument) {
    MemoryObject& object = objects_[&argument];
    object.name = "ap_return";
    object.is_scalar_port = true;
    add_layout(object, info_->result, {});
  }

  void add_parameter_object(Argument& argument, const Parameter& parameter, int index) {
    MemoryObject& object = objects_[&argument];
    object.name = parameter.name;
    object.argument = index;
    object.llvm_argument = argument.getArgNo();
    std::vector<uint64_t> dims = parameter.dims;
    bool is_open = !dims.empty() && dims[0] == 0;
    if (is_open && has_only_constant_zero_accesses(argument, parameter.layout.bytes)) dims.clear();
    if (!dims.empty() && dims[0] == 0) dims[0] = port_depth(parameter.name);
    object.is_scalar_port = dims.empty();
    object.is_aggregate = !dims.empty() && is_aggregated(argument) && !is_stored_to(argument);
    add_layout(object, parameter.layout, dims);
    object.partitions.resize(dims.size());
  }

  bool is_aggregated(Argument& argument) {
    return !middle_.directives.of(&argument, "AGGREGATE").empty() ||
           !middle_.directives.of(&argument, "DATA_PACK").empty();
  }

  bool is_stored_to(Argument& argument) {
    return any_of(instructions(function_), [&](Instruction& instruction) {
      return is_store(instruction) && getUnderlyingObject(accessed_pointer(instruction), 0) == &argument;
    });
  }

  uint64_t port_depth(const std::string& name) {
    auto ports = middle_.directives.ports.find(function_.getName().str());
    if (ports != middle_.directives.ports.end())
      for (const PortDirective& entry : ports->second)
        if (entry.port == name && entry.directive.has("depth")) return entry.directive.integer("depth", 0);
    return 65536;
  }

  /// A pointer to one object: only its first element is touched.
  bool has_only_constant_zero_accesses(Value& pointer, uint64_t bytes) {
    for (User* user : pointer.users()) {
      auto* gep = dyn_cast<GEPOperator>(user);
      if (!gep) continue;
      APInt offset(64, 0);
      if (!gep->accumulateConstantOffset(layout_, offset) || offset.isNegative() || offset.uge(bytes))
        return false;
    }
    return true;
  }

  /// Which leaves of scalar ports are read and which written; both makes a register that starts from the
  /// input.
  void find_scalar_port_uses() {
    for (Argument& pointer : function_.args()) {
      auto known = objects_.find(&pointer);
      if (known == objects_.end() || !known->second.is_scalar_port) continue;
      MemoryObject& object = known->second;
      std::set<size_t> read, written;
      for (Instruction& instruction : instructions(function_)) {
        Value* address = accessed_pointer(instruction);
        if (!address || getUnderlyingObject(address, 0) != &pointer) continue;
        size_t leaf = decode(address, instruction).leaf;
        (is_store(instruction) ? written : read).insert(leaf);
      }
      for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
        add_scalar_leaf(object, leaf, read.count(leaf), written.count(leaf));
    }
  }

  void add_scalar_leaf(MemoryObject& object, size_t leaf, bool read, bool written) {
    ScalarPort port;
    port.width = object.widths[leaf];
    port.is_signed = object.signedness[leaf];
    port.argument = object.argument;
    port.llvm_argument = object.llvm_argument;
    port.byte_offset = object.leaves[leaf].byte_offset;
    port.is_result = object.argument < 0;
    if (written) {
      ScalarPort output = port;
      output.is_output = true;
      output.name = names_.unique(read ? object.leaf_names[leaf] + "_o" : object.leaf_names[leaf]);
      object.outputs[leaf] = process_.scalars.size();
      process_.scalars.push_back(output);
    }
    if (read) {
      port.name = names_.unique(written ? object.leaf_names[leaf] + "_i" : object.leaf_names[leaf]);
      object.inputs[leaf] = process_.scalars.size();
      input_values_[{&object, leaf}] = add_input(port, object.leaves[leaf].bytes * 8);
    }
    if (read && written) {
      Memory copy;
      copy.name = names_.unique(object.leaf_names[leaf] + "_value");
      copy.kind = MemoryKind::kRegisters;
      copy.width = object.widths[leaf];
      copy.is_signed = object.signedness[leaf];
      copy.load_latency = 0;
      object.memories[{leaf, 0}] = process_.memories.size();
      process_.memories.push_back(copy);
      entry_copies_.push_back({object.memories[{leaf, 0}], input_values_[{&object, leaf}]});
    }
  }

  // --- Memory objects ---

  MemoryObject& object_at(Value* pointer, const Instruction& access) {
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

  std::string object_name(Value* pointer) {
    if (auto* global = dyn_cast<GlobalVariable>(pointer)) {
      SmallVector<DIGlobalVariableExpression*, 1> debug;
      global->getDebugInfo(debug);
      return debug.empty() ? variable_part(global->getName().str())
                           : debug[0]->getVariable()->getName().str();
    }
    return variable_part(pointer->getName().str());
  }

  void read_partitions(Value* pointer, MemoryObject& object) {
    object.partitions.resize(object.leaves.empty() ? 0 : object.leaves[0].dims.size());
    for (const Directive& directive : middle_.directives.of(pointer, "ARRAY_PARTITION")) {
      size_t dim = directive.integer("dim", 1);
      Partition partition;
      std::string type = directive.text("type");
      partition.kind = directive.has("cyclic") || type == "cyclic" ? Partition::kCyclic
                       : directive.has("block") || type == "block" ? Partition::kBlock
                                                                   : Partition::kComplete;
      partition.factor = directive.integer("factor", 2);
      for (size_t d = 0; d < object.partitions.size(); ++d)
        if (dim == 0 || dim == d + 1) object.partitions[d] = partition;
    }
  }

  static bool is_fully_partitioned(const MemoryObject& object) {
    return !object.partitions.empty() &&
           all_of(object.partitions, [](const Partition& p) { return p.kind == Partition::kComplete; });
  }

  static uint64_t bank_count(const Partition& partition, uint64_t size) {
    if (partition.kind == Partition::kNone) return 1;
    return partition.kind == Partition::kComplete ? size : std::min(partition.factor, size);
  }

  int memory_of(MemoryObject& object, Value* pointer, size_t leaf, uint64_t bank) {
    auto known = object.memories.find({leaf, bank});
    if (known != object.memories.end()) return known->second;
    const MemoryLeaf& shape = object.leaves[leaf];
    Memory memory;
    bool registers = is_fully_partitioned(object);
    uint64_t banks = 1;
    for (size_t d = 0; d < shape.dims.size(); ++d) {
      uint64_t count = registers ? 1 : bank_count(object.partitions[d], shape.dims[d]);
      banks *= count;
      memory.depth *= (shape.dims[d] + count - 1) / count;
    }
    std::string bank_suffix = banks > 1 ? "_" + std::to_string(bank) : "";
    memory.name = names_.unique(object.leaf_names[leaf] + bank_suffix, "memory");
    memory.width = object.widths[leaf];
    memory.is_signed = object.signedness[leaf];
    memory.independent = is_independent(pointer);
    memory.is_aggregate = object.is_aggregate;
    if (object.is_aggregate) {
      memory.name = names_.unique(object.name);
      memory.width = low_bit(object, object.leaves.size());
      memory.is_signed = false;
    }
    auto* global = dyn_cast<GlobalVariable>(pointer);
    if (global) memory.initial = initial_words(*global, object, leaf, bank, memory.depth);
    if (object.argument >= 0) {
      memory.kind = MemoryKind::kPort;
      memory.argument = object.argument;
      memory.llvm_argument = object.llvm_argument;
      memory.byte_offset = shape.byte_offset;
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

  bool is_constant_table(const GlobalVariable& global) { return global.isConstant(); }

  bool is_independent(Value* pointer) {
    for (const Directive& directive : middle_.directives.of(pointer, "DEPENDENCE"))
      if (directive.has("inter") && directive.has("false")) return true;
    return any_of(middle_.directives.of(pointer, "DEPENDENCE"), [](const Directive& d) {
      return d.text("type") == "inter" && d.text("dependent") == "false";
    });
  }

  /// Contents of one bank; a single word stands for all words alike.
  std::vector<APInt> initial_words(GlobalVariable& global, const MemoryObject& object, size_t leaf,
                                   uint64_t bank, uint64_t depth) {
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
      auto [at_bank, address] = place(object, shape, subscripts);
      if (at_bank != bank) continue;
      Constant* value = ConstantFoldLoadFromConst(global.getInitializer(),
                                                  Type::getIntNTy(global.getContext(), shape.bytes * 8),
                                                  APInt(64, offset), layout_);
      if (auto* integer = dyn_cast_or_null<ConstantInt>(value)) words[address] = integer->getValue();
    }
    return words;
  }

  /// Bank and word address of an element with known subscripts.
  static std::pair<uint64_t, uint64_t> place(const MemoryObject& object, const MemoryLeaf& shape,
                                             const std::vector<uint64_t>& subscripts) {
    bool registers = is_fully_partitioned(object);
    uint64_t bank = 0, address = 0;
    for (size_t d = 0; d < shape.dims.size(); ++d) {
      uint64_t count = registers ? 1 : bank_count(object.partitions[d], shape.dims[d]);
      uint64_t words = (shape.dims[d] + count - 1) / count;
      bool is_block = object.partitions[d].kind == Partition::kBlock;
      bank = bank * count + (is_block ? subscripts[d] / words : subscripts[d] % count);
      address = address * words + (is_block ? subscripts[d] % words : subscripts[d] / count);
    }
    return {bank, address};
  }

  // --- Addresses ---

  static bool is_store(const Instruction& instruction) {
    auto* call = dyn_cast<CallInst>(&instruction);
    return isa<StoreInst>(instruction) || (call && primitive_of(*call) == Primitive::kStore);
  }

  Address decode(Value* pointer, const Instruction& access) {
    if (is_element_address(pointer)) return decode_element(*cast<CallInst>(pointer), access);
    APInt constant(64, 0);
    MapVector<Value*, APInt> terms;
    Value* base = pointer;
    while (auto* gep = dyn_cast<GEPOperator>(base)) {
      if (!gep->collectOffset(layout_, 64, terms, constant))
        refuse(access, "this address has no simple form; use subscripts");
      base = gep->getPointerOperand();
    }
    Address address;
    address.object = &object_at(base, access);
    last_object_pointer_ = base;
    MemoryObject& object = *address.object;
    int64_t stride = 0;
    if (!object.leaves.empty() && !object.leaves[0].strides.empty()) stride = object.leaves[0].strides.back();
    int64_t offset = constant.getSExtValue();
    int64_t member = stride ? ((offset % stride) + stride) % stride : offset;
    bool found = false;
    for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
      if (static_cast<int64_t>(object.leaves[leaf].byte_offset) == member) {
        address.leaf = leaf;
        found = true;
      }
    if (!found)
      refuse(access, "this access to '" + object.name +
                         "' does not match one of its elements; use members and subscripts without casts");
    check_width(object.leaves[address.leaf], access);
    if (!stride) {
      if (!terms.empty())
        refuse(access, "'" + object.name + "' is accessed with a subscript but is no array");
      return address;
    }
    address.is_linear = true;
    ValueId index = constant_value(APInt(64, (offset - member) / stride, true));
    for (auto& [value, scale] : terms) {
      int64_t bytes = scale.getSExtValue();
      if (bytes % stride)
        refuse(access,
               "this address in '" + object.name + "' is not a whole number of elements; use subscripts");
      ValueId term = resized(value_of(value), 64, true, access);
      if (bytes != stride)
        term = binary(OpKind::kMul, term, constant_value(APInt(64, bytes / stride, true)), access);
      index = is_zero(index) ? term : binary(OpKind::kAdd, term, index, access);
    }
    address.subscripts = {index};
    return address;
  }

  Address decode_element(CallInst& call, const Instruction& access) {
    Address address;
    last_object_pointer_ = call.getArgOperand(0);
    address.object = &object_at(last_object_pointer_, access);
    uint64_t offset = cast<ConstantInt>(call.getArgOperand(1))->getZExtValue();
    for (size_t leaf = 0; leaf < address.object->leaves.size(); ++leaf)
      if (address.object->leaves[leaf].byte_offset == offset) address.leaf = leaf;
    check_width(address.object->leaves[address.leaf], access);
    for (unsigned i = 2; i < call.arg_size(); ++i)
      address.subscripts.push_back(value_of(call.getArgOperand(i)));
    return address;
  }

  void check_width(const MemoryLeaf& leaf, const Instruction& access) {
    Type* type = access.getType();
    if (auto* store = dyn_cast<StoreInst>(&access)) type = store->getValueOperand()->getType();
    if (auto* call = dyn_cast<CallInst>(&access); call && primitive_of(*call) == Primitive::kStore)
      type = call->getArgOperand(1)->getType();
    if (!type->isIntegerTy())
      refuse(
          access,
          "only integers can be loaded and stored here; pointers and floating point have no hardware form");
    if (type->getIntegerBitWidth() > leaf.bytes * 8)
      refuse(access, "this access covers several elements of an array at once; access them one by one");
  }

  bool is_zero(ValueId id) const {
    return process_[id].kind == OpKind::kConstant && process_[id].constant.isZero();
  }
  bool is_constant(ValueId id) const { return process_[id].kind == OpKind::kConstant; }

  /// Address and bank of a subscript list; the bank is a value of its own when it is not constant.
  struct Place {
    ValueId bank;
    ValueId address;
    uint64_t banks = 1;
  };
  Place place_of(const Address& address, const Instruction& access) {
    MemoryObject& object = *address.object;
    const MemoryLeaf& shape = object.leaves[address.leaf];
    Place result{constant_value(APInt(64, 0)), constant_value(APInt(64, 0)), 1};
    if (address.is_linear) {
      result.address = address.subscripts[0];
      return result;
    }
    bool registers = is_fully_partitioned(object);
    for (size_t d = 0; d < shape.dims.size(); ++d) {
      uint64_t count = registers ? 1 : bank_count(object.partitions[d], shape.dims[d]);
      uint64_t words = (shape.dims[d] + count - 1) / count;
      ValueId subscript = address.subscripts[d];
      bool is_block = object.partitions[d].kind == Partition::kBlock;
      ValueId quotient = divided(subscript, is_block ? words : count, access);
      ValueId remainder = remainder_of(subscript, is_block ? words : count, access);
      result.bank = combined(result.bank, count, is_block ? quotient : remainder, access);
      result.address = combined(result.address, words, is_block ? remainder : quotient, access);
      result.banks *= count;
    }
    return result;
  }

  ValueId combined(ValueId outer, uint64_t size, ValueId inner, const Instruction& access) {
    if (is_zero(outer)) return inner;
    ValueId scaled = binary(OpKind::kMul, outer, constant_value(APInt(64, size)), access);
    return is_zero(inner) ? scaled : binary(OpKind::kAdd, scaled, inner, access);
  }
  ValueId divided(ValueId value, uint64_t divisor, const Instruction& access) {
    if (divisor == 1) return value;
    if (is_constant(value)) return constant_value(process_[value].constant.udiv(divisor));
    if (isPowerOf2_64(divisor))
      return binary(OpKind::kLShr, value, constant_value(APInt(64, Log2_64(divisor))), access);
    return binary(OpKind::kUDiv, value, constant_value(APInt(64, divisor)), access);
  }
  ValueId remainder_of(ValueId value, uint64_t divisor, const Instruction& access) {
    if (divisor == 1) return constant_value(APInt(64, 0));
    if (is_constant(value)) return constant_value(APInt(64, process_[value].constant.urem(divisor)));
    if (isPowerOf2_64(divisor))
      return binary(OpKind::kAnd, value, constant_value(APInt(64, divisor - 1)), access);
    return binary(OpKind::kURem, value, constant_value(APInt(64, divisor)), access);
  }

  // --- Operations ---

  ValueId add(Operation operation, const Instruction& source, const std::string& wanted_name = "") {
    operation.block = current_block_;
    operation.location = location_of(source);
    operation.bits = operation.type_width;
    operation.name = names_.unique(wanted_name.empty() ? kind_name(operation.kind) : wanted_name);
    process_.operations.push_back(operation);
    ValueId id = process_.operations.size() - 1;
    process_.blocks[current_block_].operations.push_back(id);
    return id;
  }

  /// As add, for operations without effect: one that is there already in the block is used again.
  ValueId add_shared(const Operation& operation, const Instruction& source,
                     const std::string& wanted_name = "") {
    auto key = std::make_tuple(current_block_, operation.kind, operation.type_width, operation.operand_width,
                               operation.compare, operation.operands);
    auto known = shared_.find(key);
    if (known != shared_.end()) return known->second;
    return shared_[key] = add(operation, source, wanted_name);
  }

  static const char* kind_name(OpKind kind) {
    switch (kind) {
      case OpKind::kAdd:
        return "sum";
      case OpKind::kSub:
        return "difference";
      case OpKind::kMul:
        return "product";
      case OpKind::kUDiv:
      case OpKind::kSDiv:
        return "quotient";
      case OpKind::kURem:
      case OpKind::kSRem:
        return "remainder";
      case OpKind::kAnd:
        return "both";
      case OpKind::kOr:
        return "either";
      case OpKind::kXor:
        return "differs";
      case OpKind::kShl:
      case OpKind::kLShr:
      case OpKind::kAShr:
        return "shifted";
      case OpKind::kCompare:
        return "test";
      case OpKind::kSelect:
        return "chosen";
      case OpKind::kLoad:
        return "loaded";
      case OpKind::kRead:
        return "data";
      default:
        return "value";
    }
  }

  ValueId constant_value(const APInt& constant) {
    auto key = std::make_pair(constant.getBitWidth(), toString(constant, 16, false));
    auto known = constants_.find(key);
    if (known != constants_.end()) return known->second;
    Operation operation;
    operation.kind = OpKind::kConstant;
    operation.type_width = constant.getBitWidth();
    operation.constant = constant;
    operation.bits = std::max(1u, std::min(constant.getActiveBits(), constant.getSignificantBits()));
    operation.is_signed = constant.getSignificantBits() < constant.getActiveBits();
    process_.operations.push_back(operation);
    return constants_[key] = process_.operations.size() - 1;
  }

  ValueId binary(OpKind kind, ValueId first, ValueId second, const Instruction& source) {
    Operation operation;
    operation.kind = kind;
    operation.type_width = process_[first].type_width;
    operation.operands = {first, second};
    return add_shared(operation, source, kind == OpKind::kAdd || kind == OpKind::kMul ? "index" : "");
  }
  ValueId compare(CompareKind kind, ValueId first, ValueId second, const Instruction& source) {
    Operation operation;
    operation.kind = OpKind::kCompare;
    operation.compare = kind;
    operation.operand_width = process_[first].type_width;
    operation.type_width = 1;
    operation.operands = {first, second};
    return add_shared(operation, source);
  }
  ValueId select(ValueId condition, ValueId yes, ValueId no, const Instruction& source,
                 const std::string& name = "") {
    Operation operation;
    operation.kind = OpKind::kSelect;
    operation.type_width = process_[yes].type_width;
    operation.operands = {condition, yes, no};
    return add_shared(operation, source, name);
  }
  ValueId resized(ValueId value, unsigned width, bool is_signed, const Instruction& source) {
    unsigned from = process_[value].type_width;
    if (from == width) return value;
    if (is_constant(value))
      return constant_value(is_signed ? process_[value].constant.sextOrTrunc(width)
                                      : process_[value].constant.zextOrTrunc(width));
    Operation operation;
    operation.kind = from > width ? OpKind::kTrunc : is_signed ? OpKind::kSExt : OpKind::kZExt;
    operation.type_width = width;
    operation.operands = {value};
    return add_shared(operation, source, process_[value].name);
  }

  ValueId value_of(Value* value) {
    auto known = values_.find(value);
    if (known != values_.end()) return known->second;
    if (auto* constant = dyn_cast<ConstantInt>(value)) return constant_value(constant->getValue());
    if (isa<UndefValue>(value) && value->getType()->isIntegerTy())
      return constant_value(APInt(value->getType()->getIntegerBitWidth(), 0));
    if (auto* instruction = dyn_cast<Instruction>(value))
      refuse(*instruction, "this value has no hardware form; use integers, ap types and subscripts");
    throw CompileError(info_->location, "a value of '" + process_.source_name +
                                            "' has no hardware form; use integers, ap types and subscripts");
  }

  // --- Blocks ---

  void build_block(BasicBlock& block) {
    current_block_ = block_ids_[&block];
    process_.blocks[current_block_].name = names_.unique(block_name(block), "step");
    process_.blocks[current_block_].location = nearest_location(block.front());
    if (current_block_ == 0) copy_inout_ports();
    read_loop(block);
    for (Instruction& instruction : block)
      if (!instruction.isTerminator()) build_instruction(instruction);
    if (auto* ret = dyn_cast<ReturnInst>(block.getTerminator()); ret && ret->getReturnValue()) {
      Operation output;
      output.kind = OpKind::kOutput;
      output.operands = {returned_value(*ret)};
      output.object = result_port_;
      add(output, *ret, "result");
    }
  }

  /// Structs of up to 16 bytes return in one or two integers, which hold them as memory does.
  static unsigned returned_bits(Type* type) {
    auto* structure = dyn_cast<StructType>(type);
    if (!structure) return type->isIntegerTy() ? type->getIntegerBitWidth() : 1;
    unsigned bits = 0;
    for (Type* element : structure->elements())
      bits += element->isIntegerTy() ? element->getIntegerBitWidth() : 0;
    return bits;
  }

  ValueId returned_value(ReturnInst& ret) {
    Value* value = ret.getReturnValue();
    auto* structure = dyn_cast<StructType>(value->getType());
    if (!structure) return value_of(value);
    unsigned width = returned_bits(structure), low = 0;
    ValueId all = constant_value(APInt(width, 0));
    for (unsigned i = 0; i < structure->getNumElements(); ++i) {
      Value* part = FindInsertedValue(value, {i});
      if (!part)
        refuse(ret,
               "this return value has no hardware form; return an integer, an ap type or a struct of them");
      ValueId placed = resized(value_of(part), width, false, ret);
      if (low) placed = binary(OpKind::kShl, placed, constant_value(APInt(width, low)), ret);
      all = is_zero(all) ? placed : binary(OpKind::kOr, all, placed, ret);
      low += part->getType()->getIntegerBitWidth();
    }
    return all;
  }

  static std::string block_name(const BasicBlock& block) { return variable_part(block.getName().str()); }

  void copy_inout_ports() {
    for (auto [memory, input] : entry_copies_) {
      Operation store;
      store.kind = OpKind::kStore;
      store.object = memory;
      store.operands = {constant_value(APInt(64, 0)), input};
      process_.memories[memory].is_written = true;
      add(store, function_.getEntryBlock().front(), "copy");
    }
  }

  void read_loop(BasicBlock& block) {
    Loop* loop = loops_.getLoopFor(&block);
    if (!loop || loop->getHeader() != &block || loop->getNumBlocks() != 1) return;
    std::optional<Directive> directive = loop_directive(*loop, "PIPELINE");
    if (directive && directive->has("off")) return;
    process_.blocks[current_block_].is_loop = true;
    if (directive) process_.blocks[current_block_].wanted_ii = directive->integer("ii", 1);
    if (DebugLoc start = loop->getStartLoc()) process_.blocks[current_block_].location = location_of(start);
  }

  void build_instruction(Instruction& instruction) {
    if (isa<GetElementPtrInst>(instruction) || isa<AllocaInst>(instruction) ||
        isa<DbgInfoIntrinsic>(instruction) || isa<InsertValueInst>(instruction) ||
        is_element_address(&instruction) || instruction.isLifetimeStartOrEnd())
      return;
    ValueId id = translated(instruction);
    if (id == kNoValue) return;
    values_[&instruction] = id;
    refine(id, instruction);
  }

  std::string name_of(Instruction& instruction) {
    SmallVector<DbgValueInst*, 2> intrinsics;
    SmallVector<DbgVariableRecord*, 2> records;
    findDbgValues(intrinsics, &instruction, &records);
    for (DbgVariableRecord* record : records)
      if (!record->getVariable()->isArtificial() && record->getVariable()->getName() != "this")
        return record->getVariable()->getName().str();
    std::string name = variable_part(instruction.getName().str());
    static const std::set<std::string> empty_names = {
        "conv",   "add",    "sub",     "mul",     "cmp",    "shl",      "shr",    "and",  "or",
        "xor",    "cond",   "loadedv", "storedv", "tobool", "frombool", "inc",    "dec",  "div",
        "rem",    "narrow", "spec",    "sext",    "trunc",  "zext",     "lnot",   "call", "ref",
        "retval", "tmp",    "agg",     "lor",     "land",   "not",      "indvars"};
    return empty_names.count(name) ? "" : name;
  }

  ValueId translated(Instruction& instruction) {
    using namespace PatternMatch;
    if (accessed_pointer(instruction)) return is_store(instruction) ? store(instruction) : load(instruction);
    if (auto* call = dyn_cast<CallInst>(&instruction)) return translated_call(*call);
    if (!instruction.getType()->isIntegerTy()) {
      if (instruction.getType()->isFloatingPointTy())
        refuse(instruction, "floating point has no operators yet; use ap_fixed");
      refuse(instruction,
             "this pointer may point to several objects; access each array by its own name with a subscript");
    }
    Operation operation;
    operation.type_width = instruction.getType()->getIntegerBitWidth();
    if (isa<PHINode>(instruction)) {
      operation.kind = OpKind::kPhi;
      return add(operation, instruction, name_of(instruction));
    }
    if (isa<FreezeInst>(instruction)) return value_of(instruction.getOperand(0));
    for (Value* operand : instruction.operands()) operation.operands.push_back(value_of(operand));
    switch (instruction.getOpcode()) {
      case Instruction::Add:
        operation.kind = OpKind::kAdd;
        break;
      case Instruction::Sub:
        operation.kind = OpKind::kSub;
        break;
      case Instruction::Mul:
        operation.kind = OpKind::kMul;
        break;
      case Instruction::UDiv:
        operation.kind = OpKind::kUDiv;
        break;
      case Instruction::SDiv:
        operation.kind = OpKind::kSDiv;
        break;
      case Instruction::URem:
        operation.kind = OpKind::kURem;
        break;
      case Instruction::SRem:
        operation.kind = OpKind::kSRem;
        break;
      case Instruction::And:
        operation.kind = OpKind::kAnd;
        break;
      case Instruction::Or:
        operation.kind = OpKind::kOr;
        break;
      case Instruction::Xor:
        operation.kind = OpKind::kXor;
        break;
      case Instruction::Shl:
        operation.kind = OpKind::kShl;
        break;
      case Instruction::LShr:
        operation.kind = OpKind::kLShr;
        break;
      case Instruction::AShr:
        operation.kind = OpKind::kAShr;
        break;
      case Instruction::ZExt:
        operation.kind = OpKind::kZExt;
        break;
      case Instruction::SExt:
        operation.kind = OpKind::kSExt;
        break;
      case Instruction::Trunc:
        operation.kind = OpKind::kTrunc;
        break;
      case Instruction::Select:
        return translated_select(instruction, operation);
      case Instruction::ICmp:
        operation.kind = OpKind::kCompare;
        operation.compare = compare_kind(cast<ICmpInst>(instruction).getPredicate());
        operation.operand_width = process_[operation.operands[0]].type_width;
        break;
      default:
        refuse(instruction, std::string("'") + instruction.getOpcodeName() +
                                "' has no hardware form; use integers, ap types and subscripts");
    }
    return add(operation, instruction, name_of(instruction));
  }

  /// Selects between 1-bit values are gates.
  ValueId translated_select(Instruction& instruction, Operation operation) {
    auto [condition, yes, no] = std::tie(operation.operands[0], operation.operands[1], operation.operands[2]);
    auto is_bit = [&](ValueId id, bool bit) {
      return operation.type_width == 1 && is_constant(id) && process_[id].constant == bit;
    };
    operation.kind = OpKind::kSelect;
    if (is_bit(no, false)) {
      operation.kind = OpKind::kAnd;
      operation.operands = {condition, yes};
    } else if (is_bit(yes, true)) {
      operation.kind = OpKind::kOr;
      operation.operands = {condition, no};
    }
    return add(operation, instruction, name_of(instruction));
  }

  static CompareKind compare_kind(CmpInst::Predicate predicate) {
    switch (predicate) {
      case CmpInst::ICMP_EQ:
        return CompareKind::kEq;
      case CmpInst::ICMP_NE:
        return CompareKind::kNe;
      case CmpInst::ICMP_ULT:
        return CompareKind::kULt;
      case CmpInst::ICMP_ULE:
        return CompareKind::kULe;
      case CmpInst::ICMP_UGT:
        return CompareKind::kUGt;
      case CmpInst::ICMP_UGE:
        return CompareKind::kUGe;
      case CmpInst::ICMP_SLT:
        return CompareKind::kSLt;
      case CmpInst::ICMP_SLE:
        return CompareKind::kSLe;
      case CmpInst::ICMP_SGT:
        return CompareKind::kSGt;
      default:
        return CompareKind::kSGe;
    }
  }

  ValueId predicate_of(Value* predicate) {
    auto* constant = dyn_cast<ConstantInt>(predicate);
    return constant && constant->isOne() ? kNoValue : value_of(predicate);
  }

  // --- Dataflow regions ---

  int process_called(const CallInst& call) const {
    const Function* callee = call.getCalledFunction();
    for (size_t i = 0; region_ && callee && i < middle_.processes.size(); ++i)
      if (callee->getName() == middle_.processes[i]) return i;
    return -1;
  }

  void build_instance(CallInst& call, int index) {
    const Process& process = (*region_processes_)[index];
    Instance instance;
    instance.process = index;
    instance.name = names_.unique(process.name);
    for (const Stream& stream : process.streams) instance.streams.push_back(region_stream(call, stream));
    for (const ScalarPort& port : process.scalars)
      instance.scalars.push_back(region_scalar(call, port, instance.name));
    for (const Memory& memory : process.memories) {
      if (memory.kind != MemoryKind::kPort) continue;
      if (!memory.is_read && !memory.is_written) continue;
      Value* array = call.getArgOperand(memory.llvm_argument);
      auto* argument = dyn_cast<Argument>(array);
      if (!argument) {
        instance.channels.push_back(channel_port(call, array, memory));
        continue;
      }
      instance.memories.push_back({memory.name, objects_[argument].argument});
    }
    region_->instances.push_back(instance);
  }

  ChannelPort channel_port(CallInst& call, Value* array, const Memory& memory) {
    auto [known, is_new] = region_channels_.emplace(array, region_->channels.size());
    if (is_new) region_->channels.push_back(new_channel(call, array));
    RegionChannel& channel = region_->channels[known->second];
    int self = region_->instances.size();
    int& end = memory.is_written ? channel.writer : channel.reader;
    if (memory.is_written && memory.is_read)
      refuse(call, "process '" + (*region_processes_)[process_called(call)].name +
                       "' both reads and writes '" + channel.name +
                       "', which another process uses; give it a local array and copy");
    if (end >= 0 && end != self)
      refuse(call, "array '" + channel.name + "' has two " + (memory.is_written ? "writers" : "readers") +
                       "; give each pair of processes an array of its own");
    if (!memory.is_written && channel.writer < 0)
      refuse(call,
             "array '" + channel.name + "' is read before a process has written it; call the writer first");
    end = self;
    channel.member_widths[memory.byte_offset] = memory.width;
    return {memory.name, known->second, memory.byte_offset, address_bits(memory.depth)};
  }

  RegionChannel new_channel(CallInst& call, Value* array) {
    auto* local = dyn_cast<AllocaInst>(array);
    auto* type = local ? dyn_cast<ArrayType>(local->getAllocatedType()) : nullptr;
    if (!type)
      refuse(call,
             "only whole local arrays can lie between two processes; declare the array in the dataflow "
             "function and pass it by its name");
    RegionChannel channel;
    channel.name = names_.unique(object_name(array), "channel");
    channel.depth = 1;
    Type* element = type;
    for (; isa<ArrayType>(element); element = element->getArrayElementType())
      channel.depth *= element->getArrayNumElements();
    return channel;
  }

  int region_stream(CallInst& call, const Stream& port) {
    APInt offset(64, 0);
    Value* base =
        call.getArgOperand(port.llvm_argument)->stripAndAccumulateConstantOffsets(layout_, offset, true);
    offset += port.byte_offset;
    auto [known, is_new] =
        region_streams_.emplace(std::make_pair(base, offset.getZExtValue()), region_->streams.size());
    if (is_new) region_->streams.push_back(new_region_stream(base, offset.getZExtValue(), port.width));
    RegionStream& stream = region_->streams[known->second];
    int& end = port.is_input ? stream.reader : stream.writer;
    if (end >= 0)
      refuse(call, "stream '" + stream.name + "' has two " + (port.is_input ? "readers" : "writers") +
                       "; give each process a stream of its own");
    end = region_->instances.size();
    return known->second;
  }

  RegionStream new_region_stream(Value* base, uint64_t offset, unsigned width) {
    RegionStream stream;
    stream.width = width;
    auto port = streams_.find({base, offset});
    if (port != streams_.end()) {
      stream.name = process_.streams[port->second].name;
      stream.argument = process_.streams[port->second].argument;
      stream.index = process_.streams[port->second].index;
      return stream;
    }
    std::string name = object_name(base);
    stream.name = names_.unique(offset ? name + "_" + std::to_string(offset) : name, "stream");
    for (const Directive& directive : middle_.directives.of(base, "STREAM"))
      stream.depth = std::max<int>(2, directive.integer("depth", 2));
    return stream;
  }

  /// What feeds a scalar port of an instance: an output of the head, or for the instance's own outputs a port
  /// of the top.
  int region_scalar(CallInst& call, const ScalarPort& port, const std::string& instance) {
    Value* actual = port.llvm_argument >= 0 ? call.getArgOperand(port.llvm_argument) : nullptr;
    if (port.is_output) {
      auto* argument = dyn_cast_or_null<Argument>(actual);
      if (!argument || !objects_.count(argument))
        refuse(call, "process '" + instance + "' writes '" + port.name +
                         "', which is no parameter of the dataflow function; use an hls::stream for it");
      MemoryObject& object = objects_[argument];
      for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
        if (object.leaves[leaf].byte_offset == port.byte_offset) {
          if (!object.outputs.count(leaf)) add_scalar_leaf(object, leaf, false, true);
          return object.outputs[leaf];
        }
      refuse(call,
             "process '" + instance + "' writes a part of '" + port.name + "'; use an hls::stream for it");
    }
    ScalarPort output = port;
    output.name = names_.unique(instance + "_" + port.name);
    output.is_output = true;
    output.argument = -1;
    output.instance = region_->instances.size();
    Operation set;
    set.kind = OpKind::kOutput;
    set.operands = {actual->getType()->isPointerTy() ? pointed_scalar(call, actual, port) : value_of(actual)};
    set.object = process_.scalars.size();
    process_.scalars.push_back(output);
    add(set, call, output.name + "_set");
    return set.object;
  }

  /// The scalar at `port.byte_offset` behind a pointer that an instance takes.
  ValueId pointed_scalar(CallInst& call, Value* pointer, const ScalarPort& port) {
    APInt constant(64, 0);
    Value* base = pointer->stripAndAccumulateConstantOffsets(layout_, constant, true);
    MemoryObject& object = object_at(base, call);
    uint64_t offset = constant.getZExtValue() + port.byte_offset;
    for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf) {
      if (object.leaves[leaf].byte_offset != offset || !object.leaves[leaf].dims.empty()) continue;
      if (object.is_scalar_port) {
        if (!input_values_.count({&object, leaf})) add_scalar_leaf(object, leaf, true, false);
        return input_values_[{&object, leaf}];
      }
      Operation load;
      load.kind = OpKind::kLoad;
      load.object = memory_of(object, base, leaf, 0);
      load.type_width = object.leaves[leaf].bytes * 8;
      load.operands = {constant_value(APInt(64, 0))};
      process_.memories[load.object].is_read = true;
      return add(load, call, process_.memories[load.object].name + "_data");
    }
    refuse(call,
           "parameter '" + port.name +
               "' of a process must be a scalar, a struct, a stream or a parameter of the dataflow function");
  }

  ValueId translated_call(CallInst& call) {
    if (int process = process_called(call); process >= 0) {
      build_instance(call, process);
      return kNoValue;
    }
    Operation operation;
    switch (primitive_of(call)) {
      case Primitive::kRead:
        operation.kind = OpKind::kRead;
        operation.type_width = call.getType()->getIntegerBitWidth();
        operation.predicate = predicate_of(call.getArgOperand(1));
        operation.object = stream_of(call, true, operation.type_width);
        return add(operation, call, process_.streams[operation.object].name + "_data");
      case Primitive::kWrite:
        operation.kind = OpKind::kWrite;
        operation.operands = {value_of(call.getArgOperand(1))};
        operation.predicate = predicate_of(call.getArgOperand(2));
        operation.object = stream_of(call, false, call.getArgOperand(1)->getType()->getIntegerBitWidth());
        add(operation, call, process_.streams[operation.object].name + "_write");
        return kNoValue;
      case Primitive::kEmpty:
      case Primitive::kFull:
        operation.kind = primitive_of(call) == Primitive::kEmpty ? OpKind::kEmpty : OpKind::kFull;
        operation.type_width = 1;
        operation.object = stream_of(call, operation.kind == OpKind::kEmpty, 0);
        return add(operation, call,
                   process_.streams[operation.object].name +
                       (operation.kind == OpKind::kEmpty ? "_empty" : "_full"));
      default:
        break;
    }
    if (auto* intrinsic = dyn_cast<IntrinsicInst>(&call)) return translated_intrinsic(*intrinsic);
    std::string callee =
        call.getCalledFunction() ? call.getCalledFunction()->getName().str() : "a function pointer";
    refuse(call,
           "the call of '" + callee + "' cannot be inlined; give the function's source among the files");
  }

  int stream_of(CallInst& call, bool is_input, unsigned width) {
    APInt offset(64, 0);
    Value* base = call.getArgOperand(0)->stripAndAccumulateConstantOffsets(layout_, offset, true);
    auto known = streams_.find({base, offset.getZExtValue()});
    if (known == streams_.end())
      refuse(call,
             "cannot tell which stream is meant here; pass streams by reference and use constant subscripts");
    Stream& stream = process_.streams[known->second];
    if (stream_used_.insert(known->second).second)
      stream.is_input = is_input;
    else if (stream.is_input != is_input)
      refuse(call, "stream '" + stream.name +
                       "' is both read and written by one process; use a local array, or split the process");
    if (width) stream.width = width;
    return known->second;
  }

  ValueId translated_intrinsic(IntrinsicInst& call) {
    auto operand = [&](unsigned i) { return value_of(call.getArgOperand(i)); };
    unsigned width = call.getType()->isIntegerTy() ? call.getType()->getIntegerBitWidth() : 0;
    auto number = [&](uint64_t value) { return constant_value(APInt(width, value)); };
    auto least = [&](CompareKind kind) {
      return select(compare(kind, operand(0), operand(1), call), operand(0), operand(1), call, name_of(call));
    };
    switch (call.getIntrinsicID()) {
      case Intrinsic::umin:
        return least(CompareKind::kULt);
      case Intrinsic::umax:
        return least(CompareKind::kUGt);
      case Intrinsic::smin:
        return least(CompareKind::kSLt);
      case Intrinsic::smax:
        return least(CompareKind::kSGt);
      case Intrinsic::abs: {
        ValueId negated = binary(OpKind::kSub, number(0), operand(0), call);
        return select(compare(CompareKind::kSLt, operand(0), number(0), call), negated, operand(0), call,
                      name_of(call));
      }
      case Intrinsic::usub_sat: {
        ValueId difference = binary(OpKind::kSub, operand(0), operand(1), call);
        return select(compare(CompareKind::kULt, operand(0), operand(1), call), number(0), difference, call);
      }
      case Intrinsic::uadd_sat: {
        ValueId sum = binary(OpKind::kAdd, operand(0), operand(1), call);
        return select(compare(CompareKind::kULt, sum, operand(0), call),
                      constant_value(APInt::getAllOnes(width)), sum, call);
      }
      case Intrinsic::sadd_sat:
      case Intrinsic::ssub_sat:
        return saturated(call, operand(0), operand(1));
      case Intrinsic::fshl:
      case Intrinsic::fshr:
        return funnel_shift(call);
      case Intrinsic::ctpop:
        return population(call, operand(0));
      case Intrinsic::ctlz:
        return leading_zeros(call, operand(0), true);
      case Intrinsic::cttz:
        return leading_zeros(call, operand(0), false);
      case Intrinsic::bswap:
        return permuted(call, operand(0), 8);
      case Intrinsic::bitreverse:
        return permuted(call, operand(0), 1);
      case Intrinsic::ucmp:
      case Intrinsic::scmp: {
        bool is_signed = call.getIntrinsicID() == Intrinsic::scmp;
        ValueId more =
            resized(compare(is_signed ? CompareKind::kSGt : CompareKind::kUGt, operand(0), operand(1), call),
                    width, false, call);
        ValueId less =
            compare(is_signed ? CompareKind::kSLt : CompareKind::kULt, operand(0), operand(1), call);
        return select(less, constant_value(APInt::getAllOnes(width)), more, call);
      }
      case Intrinsic::assume:
      case Intrinsic::experimental_noalias_scope_decl:
        return kNoValue;
      default:
        refuse(call, "'" + call.getCalledFunction()->getName().str() +
                         "' has no hardware form; write it with integer operations");
    }
  }

  ValueId saturated(IntrinsicInst& call, ValueId first, ValueId second) {
    unsigned width = process_[first].type_width;
    OpKind kind = call.getIntrinsicID() == Intrinsic::sadd_sat ? OpKind::kAdd : OpKind::kSub;
    ValueId wide =
        binary(kind, resized(first, width + 1, true, call), resized(second, width + 1, true, call), call);
    ValueId high = constant_value(APInt::getSignedMaxValue(width)),
            low = constant_value(APInt::getSignedMinValue(width));
    ValueId over = compare(CompareKind::kSGt, wide,
                           constant_value(APInt::getSignedMaxValue(width).sext(width + 1)), call);
    ValueId under = compare(CompareKind::kSLt, wide,
                            constant_value(APInt::getSignedMinValue(width).sext(width + 1)), call);
    return select(over, high, select(under, low, resized(wide, width, true, call), call), call);
  }

  ValueId funnel_shift(IntrinsicInst& call) {
    unsigned width = call.getType()->getIntegerBitWidth();
    bool left = call.getIntrinsicID() == Intrinsic::fshl;
    ValueId amount = resized(value_of(call.getArgOperand(2)), 2 * width, false, call);
    ValueId modulus = constant_value(APInt(2 * width, width));
    amount = is_constant(amount) ? constant_value(process_[amount].constant.urem(process_[modulus].constant))
                                 : binary(OpKind::kURem, amount, modulus, call);
    ValueId high =
        binary(OpKind::kShl, resized(value_of(call.getArgOperand(0)), 2 * width, false, call), modulus, call);
    ValueId both =
        binary(OpKind::kOr, high, resized(value_of(call.getArgOperand(1)), 2 * width, false, call), call);
    ValueId shifted = binary(left ? OpKind::kShl : OpKind::kLShr, both, amount, call);
    if (left) shifted = binary(OpKind::kLShr, shifted, modulus, call);
    return resized(shifted, width, false, call);
  }

  ValueId bit_of(ValueId value, unsigned bit, const Instruction& source) {
    unsigned width = process_[value].type_width;
    ValueId shifted = bit ? binary(OpKind::kLShr, value, constant_value(APInt(width, bit)), source) : value;
    return resized(shifted, 1, false, source);
  }

  ValueId population(IntrinsicInst& call, ValueId value) {
    unsigned width = process_[value].type_width;
    std::vector<ValueId> terms;
    for (unsigned bit = 0; bit < width; ++bit)
      terms.push_back(resized(bit_of(value, bit, call), width, false, call));
    while (terms.size() > 1) {
      std::vector<ValueId> sums;
      for (size_t i = 0; i + 1 < terms.size(); i += 2)
        sums.push_back(binary(OpKind::kAdd, terms[i], terms[i + 1], call));
      if (terms.size() % 2) sums.push_back(terms.back());
      terms = sums;
    }
    return terms[0];
  }

  ValueId leading_zeros(IntrinsicInst& call, ValueId value, bool from_top) {
    unsigned width = process_[value].type_width;
    ValueId count = constant_value(APInt(width, width));
    for (unsigned step = width;
         step-- > 0;) {  // The bit tested last wins: start farthest from the end that counts.
      unsigned bit = from_top ? width - 1 - step : step;
      count = select(bit_of(value, bit, call), constant_value(APInt(width, step)), count, call);
    }
    return count;
  }

  ValueId permuted(IntrinsicInst& call, ValueId value, unsigned group) {
    unsigned width = process_[value].type_width;
    ValueId result = constant_value(APInt(width, 0));
    for (unsigned low = 0; low < width; low += group) {
      ValueId part =
          resized(low ? binary(OpKind::kLShr, value, constant_value(APInt(width, low)), call) : value, group,
                  false, call);
      ValueId placed = resized(part, width, false, call);
      unsigned to = width - group - low;
      if (to) placed = binary(OpKind::kShl, placed, constant_value(APInt(width, to)), call);
      result = is_zero(result) ? placed : binary(OpKind::kOr, result, placed, call);
    }
    return result;
  }

  // --- Loads and stores ---

  ValueId load(Instruction& instruction) {
    Address address = decode(accessed_pointer(instruction), instruction);
    unsigned width = instruction.getType()->getIntegerBitWidth();
    MemoryObject& object = *address.object;
    if (object.is_scalar_port && !object.memories.count({address.leaf, 0}))
      return resized(input_values_[{&object, address.leaf}], width, false, instruction);
    Value* pointer = last_object_pointer_;
    // A load that the program skips does no harm: it needs no predicate and can start early.
    Place place = place_of(address, instruction);
    unsigned memory_width = object.leaves[address.leaf].bytes * 8;
    auto load_bank = [&](uint64_t bank) {
      Operation operation;
      operation.kind = OpKind::kLoad;
      operation.object = memory_of(object, pointer, address.leaf, bank);
      operation.type_width = memory_width;
      operation.operands = {place.address};
      process_.memories[operation.object].is_read = true;
      return add(operation, instruction, process_.memories[operation.object].name + "_data");
    };
    if (object.is_aggregate)
      return resized(load_member(address, place, pointer, instruction), width, false, instruction);
    ValueId loaded;
    if (is_constant(place.bank)) {
      loaded = load_bank(checked_bank(place, object, instruction));
    } else {
      loaded = load_bank(0);
      for (uint64_t bank = 1; bank < place.banks; ++bank) {
        ValueId here = compare(CompareKind::kEq, place.bank, constant_value(APInt(64, bank)), instruction);
        loaded = select(here, load_bank(bank), loaded, instruction);
      }
    }
    return resized(loaded, width, false, instruction);
  }

  /// Bits of an aggregate's word below a leaf.
  static unsigned low_bit(const MemoryObject& object, size_t leaf) {
    return std::accumulate(object.widths.begin(), object.widths.begin() + leaf, 0u);
  }

  /// A member of an element outside: all members of one element share one access.
  ValueId load_member(const Address& address, const Place& place, Value* pointer, Instruction& instruction) {
    MemoryObject& object = *address.object;
    int memory = memory_of(object, pointer, 0, 0);
    ValueId& word =
        shared_words_.emplace(std::make_tuple(current_block_, memory, place.address), kNoValue).first->second;
    if (word == kNoValue) {
      Operation operation;
      operation.kind = OpKind::kLoad;
      operation.object = memory;
      operation.type_width = process_.memories[memory].width;
      operation.operands = {place.address};
      process_.memories[memory].is_read = true;
      word = add(operation, instruction, process_.memories[memory].name + "_word");
    }
    unsigned low = low_bit(object, address.leaf), whole = process_[word].type_width;
    ValueId part = low ? binary(OpKind::kLShr, word, constant_value(APInt(whole, low)), instruction) : word;
    part = resized(part, object.widths[address.leaf], false, instruction);
    return resized(part, object.leaves[address.leaf].bytes * 8, object.signedness[address.leaf], instruction);
  }

  uint64_t checked_bank(const Place& place, const MemoryObject& object, const Instruction& instruction) {
    uint64_t bank = process_[place.bank].constant.getZExtValue();
    if (bank >= place.banks)
      refuse(instruction, "the subscript is outside of '" + object.name + "'; correct it");
    return bank;
  }

  ValueId store(Instruction& instruction) {
    Address address = decode(accessed_pointer(instruction), instruction);
    MemoryObject& object = *address.object;
    Value* pointer = last_object_pointer_;
    auto* call = dyn_cast<CallInst>(&instruction);
    ValueId data = value_of(call ? call->getArgOperand(1) : cast<StoreInst>(instruction).getValueOperand());
    ValueId predicate = call ? predicate_of(call->getArgOperand(2)) : kNoValue;
    if (process_[data].type_width < object.leaves[address.leaf].bytes * 8 &&
        object.leaves[address.leaf].bytes > 1)
      refuse(instruction,
             "this store covers a part of an element of '" + object.name + "'; store the whole element");
    if (object.is_scalar_port) store_output(object, address.leaf, data, predicate, instruction);
    if (object.is_scalar_port && !object.memories.count({address.leaf, 0})) return kNoValue;
    Place place = place_of(address, instruction);
    auto store_bank = [&](uint64_t bank, ValueId condition) {
      Operation operation;
      operation.kind = OpKind::kStore;
      operation.object = memory_of(object, pointer, address.leaf, bank);
      operation.operands = {place.address, data};
      operation.predicate = condition;
      process_.memories[operation.object].is_written = true;
      add(operation, instruction, process_.memories[operation.object].name + "_store");
    };
    if (is_constant(place.bank)) {
      store_bank(checked_bank(place, object, instruction), predicate);
    } else {
      for (uint64_t bank = 0; bank < place.banks; ++bank) {
        ValueId here = compare(CompareKind::kEq, place.bank, constant_value(APInt(64, bank)), instruction);
        store_bank(bank, predicate == kNoValue ? here : binary(OpKind::kAnd, predicate, here, instruction));
      }
    }
    return kNoValue;
  }

  void store_output(MemoryObject& object, size_t leaf, ValueId data, ValueId predicate,
                    Instruction& instruction) {
    Operation output;
    output.kind = OpKind::kOutput;
    output.operands = {data};
    output.predicate = predicate;
    output.object = object.outputs[leaf];
    add(output, instruction, object.name + "_set");
  }

  // --- Widths known from LLVM's analyses ---

  void refine(ValueId id, Instruction& instruction) {
    if (!instruction.getType()->isIntegerTy()) return;
    Operation& operation = process_[id];
    if (operation.kind == OpKind::kConstant || operation.kind == OpKind::kInput ||
        operation.type_width != instruction.getType()->getIntegerBitWidth())
      return;
    unsigned width = operation.type_width;
    unsigned unsigned_bits = width - computeKnownBits(&instruction, layout_).countMinLeadingZeros();
    unsigned signed_bits = width - ComputeNumSignBits(&instruction, layout_) + 1;
    if (evolution_.isSCEVable(instruction.getType())) {
      const SCEV* form = evolution_.getSCEV(&instruction);
      unsigned_bits = std::min(unsigned_bits, evolution_.getUnsignedRangeMax(form).getActiveBits());
      unsigned low = evolution_.getSignedRangeMin(form).getSignificantBits(),
               high = evolution_.getSignedRangeMax(form).getSignificantBits();
      signed_bits = std::min(signed_bits, std::max(low, high));
    }
    bool is_signed = signed_bits < unsigned_bits;
    unsigned bits = std::max(1u, is_signed ? signed_bits : unsigned_bits);
    if (bits < operation.bits) {
      operation.bits = bits;
      operation.is_signed = is_signed;
    }
  }

  // --- Control flow ---

  void finish_block(BasicBlock& block) {
    Block& built = process_.blocks[block_ids_[&block]];
    SmallVector<BasicBlock*, 4> sources;
    for (BasicBlock* from : predecessors(&block))
      if (block_ids_.count(from) && !is_contained(sources, from)) sources.push_back(from);
    std::sort(sources.begin(), sources.end(),
              [&](BasicBlock* a, BasicBlock* b) { return block_ids_[a] < block_ids_[b]; });
    for (BasicBlock* from : sources) built.predecessors.push_back(block_ids_[from]);
    for (PHINode& phi : block.phis()) {
      if (!values_.count(&phi)) continue;
      for (BasicBlock* from : sources) {
        ValueId incoming = value_of(phi.getIncomingValueForBlock(from));  // May add a constant.
        process_[values_[&phi]].operands.push_back(incoming);
      }
    }
    built.terminator = terminator_of(*block.getTerminator());
  }

  Terminator terminator_of(Instruction& instruction) {
    Terminator terminator;
    if (auto* branch = dyn_cast<BranchInst>(&instruction)) {
      terminator.kind = branch->isConditional() ? Terminator::kBranch : Terminator::kJump;
      if (branch->isConditional()) terminator.condition = value_of(branch->getCondition());
      for (unsigned i = 0; i < branch->getNumSuccessors(); ++i)
        terminator.targets.push_back(block_ids_[branch->getSuccessor(i)]);
    } else if (auto* choice = dyn_cast<SwitchInst>(&instruction)) {
      terminator.kind = Terminator::kSwitch;
      terminator.condition = value_of(choice->getCondition());
      terminator.targets.push_back(block_ids_[choice->getDefaultDest()]);
      for (auto& one : choice->cases()) {
        terminator.targets.push_back(block_ids_[one.getCaseSuccessor()]);
        terminator.cases.push_back(one.getCaseValue()->getValue());
      }
    } else if (!isa<ReturnInst>(instruction) && !isa<UnreachableInst>(instruction)) {
      refuse(instruction, "this control flow has no hardware form; use if, switch and loops");
    }
    return terminator;
  }

  const MiddleResult& middle_;
  Function& function_;
  const DataLayout& layout_;
  const FunctionInfo* info_ = nullptr;
  TargetLibraryInfoImpl library_info_;
  TargetLibraryInfo library_;
  AssumptionCache assumptions_;
  DominatorTree dominators_;
  LoopInfo loops_;
  ScalarEvolution evolution_;

  Region* region_ = nullptr;
  const std::vector<Process>* region_processes_ = nullptr;
  std::map<std::pair<Value*, uint64_t>, int> region_streams_;
  std::map<Value*, int> region_channels_;

  Process process_;
  NameTable names_;
  int current_block_ = 0;
  int result_port_ = -1;
  Value* last_object_pointer_ = nullptr;
  std::map<Value*, ValueId> values_;
  std::map<std::pair<unsigned, std::string>, ValueId> constants_;
  std::map<std::tuple<int, OpKind, unsigned, unsigned, CompareKind, std::vector<ValueId>>, ValueId> shared_;
  std::map<std::tuple<int, int, ValueId>, ValueId> shared_words_;  ///< Loads of whole elements from ports.
  std::map<BasicBlock*, int> block_ids_;
  std::map<Value*, MemoryObject> objects_;
  std::map<std::pair<MemoryObject*, size_t>, ValueId> input_values_;
  std::vector<std::pair<int, ValueId>> entry_copies_;
  std::map<std::pair<Value*, uint64_t>, int> streams_;
  std::set<int> stream_used_;
};

}  // namespace

Process build_process(const Program& program, const MiddleResult& middle, const std::string& function,
                      const std::string& module_name) {
  return ProcessBuilder(program, middle, function, module_name).build();
}

Region build_region(const Program& program, const MiddleResult& middle,
                    const std::vector<Process>& processes) {
  const FunctionInfo& top = program.functions.at(program.top);
  return ProcessBuilder(program, middle, program.top, top.name + "_head").build_region(processes);
}

}  // namespace hlsc
