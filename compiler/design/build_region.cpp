#include <regex>

#include "design/process_builder.h"
#include "middle/primitives.h"
#include "middle/source_location.h"
#include "middle/tasks.h"

namespace hlsc {

using namespace llvm;

Region ProcessBuilder::build_region(const std::vector<Process>& processes) {
  Region region;
  region_ = &region;
  region_processes_ = &processes;
  region.head = build();
  for (const RegionStream& stream : region.streams) check_ends(stream);
  for (const RegionChannel& channel : region.channels)
    if (channel.reader < 0 && !channel.read_back.empty())
      throw CompileError(channel.location, "array '" + channel.name +
                                               "' is used by this process alone; declare it in the process");
  // The region's streams pass the head by; a loop's head has one of its own.
  region.head.streams.erase(region.head.streams.begin(), region.head.streams.end() - region.is_loop);
  return region;
}

void ProcessBuilder::check_ends(const RegionStream& stream) const {
  if (stream.argument >= 0 || (stream.writer >= 0 && stream.reader >= 0)) return;
  throw CompileError(stream.location, "stream '" + stream.name + "' is " +
                                          (stream.writer < 0 ? "read here but no process writes it"
                                                             : "written here but no process reads it") +
                                          "; every stream of a dataflow function needs both");
}

int ProcessBuilder::process_called(const CallInst& call) const {
  const Function* callee = call.getCalledFunction();
  for (size_t i = 0; region_ && callee && i < middle_.processes.size(); ++i)
    if (callee->getName() == middle_.processes[i]) return i;
  return -1;
}

void ProcessBuilder::build_instance(CallInst& call, int index) {
  note_loop(call);
  const Process& process = (*region_processes_)[index];
  Instance instance;
  instance.process = index;
  instance.name = names_.unique(process.name);
  for (const Stream& stream : process.streams) instance.streams.push_back(region_stream(call, stream));
  for (size_t i = 0; i < process.scalars.size(); ++i)
    instance.scalars.push_back(region_scalar(call, process, i, instance.name));
  for (const Memory& memory : process.memories) {
    if (memory.kind != MemoryKind::kPort) continue;
    if (!memory.is_read && !memory.is_written) continue;
    Value* array = call.getArgOperand(memory.llvm_argument);
    auto* argument = dyn_cast<Argument>(array);
    if (!argument) {
      instance.channels.push_back(channel_port(call, array, memory));
      continue;
    }
    instance.memories.push_back(memory_tie(call, *argument, memory));
  }
  instance.is_task = is_task(call);
  bool has_banks_of_runs = any_of(
      instance.channels, [&](const ChannelPort& port) { return !region_->channels[port.channel].has_locks; });
  if (instance.is_task && !(process.scalars.empty() && instance.memories.empty() && !has_banks_of_runs))
    refuse(call, "task '" + instance.name + "' takes more than streams; send the other values by streams");
  region_->instances.push_back(instance);
}

void ProcessBuilder::note_loop(CallInst& call) {
  const Loop* loop = loops_.getLoopFor(call.getParent());
  if (!last_instance_call_) region_->is_loop = loop != nullptr;
  const Loop* known = last_instance_call_ ? loops_.getLoopFor(last_instance_call_->getParent()) : loop;
  if (loop != known || (loop && last_instance_call_ && call.getParent() != last_instance_call_->getParent()))
    refuse(call,
           "the processes of a DATAFLOW loop must be called in every iteration of that one loop; put other "
           "calls into a function of their own");
  last_instance_call_ = &call;
}

/// The runs' stream stands behind those of the parameters, and is the only one that stays (build_region).
void ProcessBuilder::write_run(Instruction& source) {
  Stream runs;
  runs.name = names_.unique("runs");
  Operation joined;
  joined.kind = OpKind::kConcat;
  for (size_t i = 0; i < run_values_.size(); ++i) {
    const ScalarPort& port = region_->run_scalars[i];
    joined.operands.push_back(resized(run_values_[i], port.width, port.is_signed, source));
    runs.width += port.width;
  }
  joined.type_width = runs.width;
  Operation write;
  write.kind = OpKind::kWrite;
  write.object = 0;
  write.operands = {runs.width ? add(joined, source, "run") : constant_value(APInt(1, 0))};
  runs.width = std::max(1u, runs.width);
  add(write, source, "runs_write");
  process_.streams.push_back(runs);
}

bool ProcessBuilder::takes_one(CallInst& call, const Memory& memory) {
  auto process = program_.functions.find(call.getCalledFunction()->getName().str());
  return process != program_.functions.end() && process->second.parameters[memory.argument].dims.empty();
}

MemoryTie ProcessBuilder::memory_tie(CallInst& call, Argument& argument, const Memory& memory) {
  MemoryObject& object = objects_[&argument];
  MemoryTie tie{memory.name, object.name, object.argument};
  for (size_t leaf = 0; leaf < object.leaves.size() && !memory.is_aggregate; ++leaf)
    if (object.leaves[leaf].byte_offset == memory.byte_offset) {
      // The region alone takes the elements of an array in a struct for scalars: `out[0]` leads to `out`.
      std::string& name = object.leaf_names[leaf];
      static const std::regex kSubscript("\\[\\d+\\]");
      if (name.find('[') != std::string::npos)
        name = names_.unique(takes_one(call, memory) ? std::regex_replace(name, kSubscript, "") : name);
      tie.outside = name;
    }
  for (const Instance& other : region_->instances)
    for (const MemoryTie& taken : other.memories)
      if (taken.outside == tie.outside)
        refuse(call, "array '" + object.name +
                         "' is used by two processes; let the first pass it on in a local array");
  return tie;
}

ChannelPort ProcessBuilder::channel_port(CallInst& call, Value* array, const Memory& memory) {
  APInt offset(64, 0);
  Value* base = array->stripAndAccumulateConstantOffsets(layout_, offset, true);
  auto [known, is_new] =
      region_channels_.emplace(std::make_pair(base, offset.getZExtValue()), region_->channels.size());
  if (is_new) region_->channels.push_back(new_channel(call, array));
  RegionChannel& channel = region_->channels[known->second];
  if (channel.has_locks) channel.depth = std::max(channel.depth, memory.depth);
  int self = region_->instances.size();
  int& end = memory.is_written ? channel.writer : channel.reader;
  bool reads_back = memory.is_written && memory.is_read;
  if (reads_back && channel.writer >= 0 && channel.writer != self)
    refuse(call, "process '" + (*region_processes_)[process_called(call)].name + "' both reads and writes '" +
                     channel.name + "', which another process has written; give it a local array and copy");
  if (end >= 0 && end != self)
    refuse(call, "array '" + channel.name + "' has two " + (memory.is_written ? "writers" : "readers") +
                     "; give each pair of processes an array of its own");
  if (!memory.is_written && channel.writer < 0 && !channel.has_locks)
    refuse(call,
           "array '" + channel.name + "' is read before a process has written it; call the writer first");
  end = self;
  channel.member_widths[memory.byte_offset] = memory.width;
  if (reads_back) channel.read_back.insert(memory.byte_offset);
  return {memory.name, known->second, memory.byte_offset, address_bits(memory.depth), reads_back};
}

RegionChannel ProcessBuilder::new_channel(CallInst& call, Value* array) {
  auto* local = dyn_cast<AllocaInst>(array);
  auto* type = local ? dyn_cast<ArrayType>(local->getAllocatedType()) : nullptr;
  if (!type)
    refuse(call,
           "only whole local arrays can lie between two processes; declare the array in the dataflow "
           "function and pass it by its name");
  RegionChannel channel;
  channel.name = names_.unique(object_name(array), "channel");
  channel.location = nearest_location(call);
  channel.depth = 1;
  Type* element = type;
  for (; isa<ArrayType>(element); element = element->getArrayElementType())
    channel.depth *= element->getArrayNumElements();
  return channel;
}

int ProcessBuilder::region_stream(CallInst& call, const Stream& port) {
  APInt offset(64, 0);
  Value* base =
      port.global.empty()
          ? call.getArgOperand(port.llvm_argument)->stripAndAccumulateConstantOffsets(layout_, offset, true)
          : function_.getParent()->getNamedValue(port.global);
  offset += port.byte_offset;
  auto [known, is_new] =
      region_streams_.emplace(std::make_pair(base, offset.getZExtValue()), region_->streams.size());
  if (is_new) region_->streams.push_back(new_region_stream(base, offset.getZExtValue(), port.width));
  RegionStream& stream = region_->streams[known->second];
  if (is_new) stream.location = nearest_location(call);
  int& end = port.is_input ? stream.reader : stream.writer;
  if (end < 0 && port.is_lock) tie_to_channel(stream, port, base, offset.getZExtValue() - port.byte_offset);
  if (end >= 0)
    refuse(call, "stream '" + stream.name + "' has two " + (port.is_input ? "readers" : "writers") +
                     "; give each process a stream of its own");
  end = region_->instances.size();
  return known->second;
}

/// hls_streamofblocks.h: the tokens of the claimed banks come first, then those of the filled ones.
void ProcessBuilder::tie_to_channel(RegionStream& stream, const Stream& port, Value* base, uint64_t place) {
  auto [known, is_new] = region_channels_.emplace(std::make_pair(base, place), region_->channels.size());
  if (is_new) {
    RegionChannel channel;
    channel.name = names_.unique(object_name(base) + (place ? "_" + std::to_string(place) : ""), "channel");
    channel.location = stream.location;
    channel.has_locks = true;
    for (const ObjectDirective& entry : middle_.directives.of(base, "STREAM"))
      channel.banks = std::max<int>(2, entry.directive.integer("depth", 2));
    region_->channels.push_back(channel);
  }
  stream.channel = known->second;
  stream.fills = port.byte_offset > 0;
  RegionChannel& channel = region_->channels[known->second];
  (port.is_input ? channel.reader : channel.writer) = region_->instances.size();
}

RegionStream ProcessBuilder::new_region_stream(Value* base, uint64_t offset, unsigned width) {
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
  for (const ObjectDirective& entry : middle_.directives.of(base, "STREAM"))
    stream.depth = std::max<int>(1, entry.directive.integer("depth", 2));
  return stream;
}

std::pair<Value*, uint64_t> ProcessBuilder::local_scalar(Value* actual, const ScalarPort& port) {
  while (actual && isa<CastInst>(actual)) actual = cast<CastInst>(actual)->getOperand(0);
  auto* load = dyn_cast_or_null<CallInst>(actual);
  bool is_loaded = load && primitive_of(*load) == Primitive::kLoad;
  Value* pointer = is_loaded ? load->getArgOperand(0) : actual;
  if (!pointer || !pointer->getType()->isPointerTy()) return {nullptr, 0};
  APInt offset(64, is_loaded ? 0 : port.byte_offset);
  Value* base = pointer->stripAndAccumulateConstantOffsets(layout_, offset, true);
  return {isa<AllocaInst>(base) ? base : nullptr, offset.getZExtValue()};
}

int ProcessBuilder::region_scalar(CallInst& call, const Process& process, int index,
                                  const std::string& instance) {
  const ScalarPort& port = process.scalars[index];
  Value* actual = port.llvm_argument >= 0 ? call.getArgOperand(port.llvm_argument) : nullptr;
  int self = region_->instances.size();
  auto local = local_scalar(actual, port);
  if (port.is_output) {
    if (local.first) {
      region_scalar_writers_[local] = {self, index};
      return -1;
    }
    auto* argument = dyn_cast_or_null<Argument>(actual);
    if (!argument || !objects_.count(argument))
      refuse(call, "process '" + instance + "' gives '" + port.name +
                       "' back, which no other process takes; let it write a parameter or an hls::stream");
    MemoryObject& object = objects_[argument];
    for (size_t leaf = 0; leaf < object.leaves.size(); ++leaf)
      if (object.leaves[leaf].byte_offset == port.byte_offset) {
        if (!object.outputs.count(leaf)) add_scalar_leaf(object, leaf, false, true);
        return object.outputs[leaf];
      }
    refuse(call,
           "process '" + instance + "' writes a part of '" + port.name + "'; use an hls::stream for it");
  }
  if (auto writer = region_scalar_writers_.find(local);
      local.first && writer != region_scalar_writers_.end()) {
    const auto& [from, output] = writer->second;
    const ScalarPort& source = (*region_processes_)[region_->instances[from].process].scalars[output];
    region_->scalars.push_back({names_.unique(object_name(local.first), "scalar"), source.width,
                                source.is_signed, from, self, output, index});
    return -1;
  }
  ScalarPort output = port;
  output.name = names_.unique(instance + "_" + port.name);
  output.is_output = true;
  output.argument = -1;
  output.instance = region_->instances.size();
  ValueId value = actual->getType()->isPointerTy() ? pointed_scalar(call, actual, port) : value_of(actual);
  region_->run_scalars.push_back(output);
  if (region_->is_loop) {
    run_values_.push_back(value);
  } else {
    Operation set;
    set.kind = OpKind::kOutput;
    set.operands = {value};
    set.object = process_.scalars.size();
    process_.scalars.push_back(output);
    add(set, call, output.name + "_set");
  }
  return region_->run_scalars.size() - 1;
}

ValueId ProcessBuilder::pointed_scalar(CallInst& call, Value* pointer, const ScalarPort& port) {
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

}  // namespace hlsc
