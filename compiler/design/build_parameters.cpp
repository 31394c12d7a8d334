#include "design/process_builder.h"
#include "middle/primitives.h"

namespace hlsc {

using namespace llvm;

void ProcessBuilder::read_parameters() {
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

void ProcessBuilder::read_parameter(Argument& argument, const Parameter& parameter, int index) {
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
    bool is_top = function_.getName() == program_.top;
    if (is_top || parameter.members.leaves.empty()) return;
    Parameter members = parameter;
    members.layout = parameter.members;
    add_parameter_object(argument, members, index);
  } else if (argument.getType()->isPointerTy()) {
    add_parameter_object(argument, parameter, index);
  } else {
    add_scalar_input(argument, parameter, index);
  }
}

void ProcessBuilder::add_scalar_input(Argument& argument, const Parameter& parameter, int index) {
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

ValueId ProcessBuilder::add_input(const ScalarPort& port, unsigned type_width) {
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

void ProcessBuilder::add_layout(MemoryObject& object, const TypeLayout& layout,
                                const std::vector<uint64_t>& dims) {
  std::vector<uint64_t> strides(dims.size(), layout.bytes);
  for (size_t d = dims.size(); d-- > 1;) strides[d - 1] = strides[d] * dims[d];
  for (const Leaf& leaf : layout.leaves) {
    object.leaves.push_back({leaf.name, leaf.byte_offset, leaf.bytes, dims, strides});
    object.partitions.emplace_back(dims.size());
    object.widths.push_back(leaf.width);
    object.signedness.push_back(leaf.is_signed);
    object.leaf_names.push_back(leaf.name.empty() ? object.name : object.name + "_" + leaf.name);
  }
}

namespace {

/// A name without its subscripts, and the subscripts: `taps[3].x` is `taps.x` and 3.
std::pair<std::string, std::vector<uint64_t>> without_subscripts(const std::string& name) {
  std::string plain;
  std::vector<uint64_t> subscripts;
  for (size_t i = 0; i < name.size(); ++i) {
    if (name[i] != '[') {
      plain += name[i];
      continue;
    }
    subscripts.push_back(std::stoull(name.substr(i + 1)));
    i = name.find(']', i);
  }
  return {plain, subscripts};
}

}  // namespace

void ProcessBuilder::add_member_arrays(MemoryObject& object, const TypeLayout& layout) {
  std::map<std::string, size_t> known;
  for (const Leaf& leaf : layout.leaves) {
    auto [name, subscripts] = without_subscripts(leaf.name);
    auto [place, is_new] = known.emplace(name, object.leaves.size());
    if (is_new) {
      object.leaves.push_back({name, leaf.byte_offset, leaf.bytes,
                               std::vector<uint64_t>(subscripts.size(), 1),
                               std::vector<uint64_t>(subscripts.size(), leaf.bytes)});
      object.partitions.emplace_back(subscripts.size());
      object.widths.push_back(leaf.width);
      object.signedness.push_back(leaf.is_signed);
      object.leaf_names.push_back(object.name + "_" + name);
    }
    MemoryLeaf& whole = object.leaves[place->second];
    for (size_t d = 0; d < subscripts.size(); ++d) {
      bool is_step = subscripts[d] == 1 && std::count(subscripts.begin(), subscripts.end(), 0) ==
                                               static_cast<long>(subscripts.size()) - 1;
      if (is_step) whole.strides[d] = leaf.byte_offset - whole.byte_offset;
      whole.dims[d] = std::max(whole.dims[d], subscripts[d] + 1);
    }
  }
}

void ProcessBuilder::add_result_object(Argument& argument) {
  MemoryObject& object = objects_[&argument];
  object.name = "ap_return";
  object.is_scalar_port = true;
  add_layout(object, info_->result, {});
}

void ProcessBuilder::add_parameter_object(Argument& argument, const Parameter& parameter, int index) {
  MemoryObject& object = objects_[&argument];
  object.name = parameter.name;
  object.argument = index;
  object.llvm_argument = argument.getArgNo();
  std::vector<uint64_t> dims = parameter.dims;
  bool is_open = !dims.empty() && dims[0] == 0;
  if (is_open && has_only_constant_zero_accesses(argument, parameter.layout.bytes)) dims.clear();
  if (!dims.empty() && dims[0] == 0) dims[0] = port_depth(argument, parameter);
  bool has_member_arrays =
      dims.empty() && any_of(argument.users(), [](User* user) { return is_element_address(user); });
  object.is_scalar_port = dims.empty() && !has_member_arrays;
  object.is_aggregate = !dims.empty() && is_aggregated(argument) && !is_stored_to(argument);
  if (has_member_arrays)
    add_member_arrays(object, parameter.layout);
  else
    add_layout(object, parameter.layout, dims);
  if (!region_ || object.is_scalar_port) return;
  for (std::string& name : object.leaf_names) name = names_.unique(name);  // Ports of the top.
}

bool ProcessBuilder::is_aggregated(Argument& argument) {
  return !middle_.directives.of(&argument, "AGGREGATE").empty() ||
         !middle_.directives.of(&argument, "DATA_PACK").empty();
}

bool ProcessBuilder::is_stored_to(Argument& argument) {
  return any_of(instructions(function_), [&](Instruction& instruction) {
    return is_store(instruction) && getUnderlyingObject(accessed_pointer(instruction), 0) == &argument;
  });
}

uint64_t ProcessBuilder::port_depth(Argument& argument, const Parameter& parameter) {
  auto ports = middle_.directives.ports.find(function_.getName().str());
  if (ports != middle_.directives.ports.end())
    for (const PortDirective& entry : ports->second)
      if (entry.port == parameter.name && entry.directive.has("depth"))
        return entry.directive.integer("depth", 0);
  uint64_t elements = 0;  // Of the callers' arrays.
  for (User* user : function_.users())
    if (auto* call = dyn_cast<CallInst>(user))
      elements = std::max(elements,
                          elements_behind(call->getArgOperand(argument.getArgNo()), parameter.layout.bytes));
  if (elements == 0)
    throw CompileError(info_->location, "the size of '" + parameter.name +
                                            "' is not known; declare it as an array, " + parameter.name +
                                            "[64], or give INTERFACE port=" + parameter.name + " a depth");
  return elements;
}

uint64_t ProcessBuilder::elements_behind(Value* actual, uint64_t bytes) {
  Value* object = getUnderlyingObject(actual, 0);
  if (auto* local = dyn_cast<AllocaInst>(object))
    return layout_.getTypeAllocSize(local->getAllocatedType()) / bytes;
  if (auto* global = dyn_cast<GlobalVariable>(object))
    return layout_.getTypeAllocSize(global->getValueType()) / bytes;
  auto* outer = dyn_cast<Argument>(object);
  if (!outer) return 0;
  auto caller = program_.functions.find(outer->getParent()->getName().str());
  if (caller == program_.functions.end()) return 0;
  for (const Parameter& parameter : caller->second.parameters) {
    if (parameter.name != outer->getName()) continue;
    uint64_t elements = parameter.dims.empty() ? 0 : 1;
    for (uint64_t size : parameter.dims) elements *= size;
    auto ports = middle_.directives.ports.find(caller->first);
    if (elements == 0 && ports != middle_.directives.ports.end())
      for (const PortDirective& entry : ports->second)
        if (entry.port == parameter.name) elements = entry.directive.integer("depth", elements);
    return elements;
  }
  return 0;
}

bool ProcessBuilder::has_only_constant_zero_accesses(Value& pointer, uint64_t bytes) {
  for (User* user : pointer.users()) {
    auto* gep = dyn_cast<GEPOperator>(user);
    if (!gep) continue;
    APInt offset(64, 0);
    if (!gep->accumulateConstantOffset(layout_, offset) || offset.isNegative() || offset.uge(bytes))
      return false;
  }
  return true;
}

void ProcessBuilder::find_scalar_port_uses() {
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

void ProcessBuilder::add_scalar_leaf(MemoryObject& object, size_t leaf, bool read, bool written) {
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

unsigned ProcessBuilder::returned_bits(Type* type) {
  auto* structure = dyn_cast<StructType>(type);
  if (!structure) return type->isIntegerTy() ? type->getIntegerBitWidth() : 1;
  unsigned bits = 0;
  for (Type* element : structure->elements())
    bits += element->isIntegerTy() ? element->getIntegerBitWidth() : 0;
  return bits;
}

}  // namespace hlsc
