#include "report/report.h"

#include <algorithm>
#include <map>

#include "tool/compile.h"

namespace hlsc {
namespace {

class ModuleReporter {
 public:
  ModuleReporter(const CompiledProcess& compiled, const ScheduleOptions& options)
      : process_(compiled.process), schedule_(compiled.schedule), options_(options) {}

  ModuleReport run() {
    report_.name = process_.name;
    report_.source_name = process_.source_name;
    report_.location = process_.location;
    LatencyModel latency(process_, schedule_);
    report_.latency = latency.process();
    for (size_t i = 0; i < process_.loops.size(); ++i) report_.loops.push_back(loop(i, latency));
    for (size_t i = 0; i < process_.memories.size(); ++i) add_memory(i);
    for (size_t i = 0; i < process_.blocks.size(); ++i) report_.blocks.push_back(block(i));
    count_operators();
    report_.resources = estimate(process_, schedule_, options_.target);
    report_.chain = longest_chain();
    return report_;
  }

 private:
  LoopReport loop(int index, LatencyModel& latency) const {
    const SourceLoop& loop = process_.loops[index];
    const BlockSchedule& timing = schedule_.blocks[loop.header];
    LoopReport made;
    made.name = loop.name;
    made.location = loop.location;
    for (int outer = loop.parent; outer >= 0; outer = process_.loops[outer].parent) ++made.depth_in_nest;
    made.is_pipelined = process_.blocks[loop.header].is_loop;
    if (made.is_pipelined) {
      made.asked_ii = timing.wanted_ii;
      made.ii = timing.ii;
      made.limit = timing.limit;
      made.stages = timing.length;
    }
    made.least_trips = loop.least_trips;
    made.most_trips = loop.most_trips;
    made.latency = latency.loop(index);
    return made;
  }

  void add_memory(int index) {
    const Memory& memory = process_.memories[index];
    MemoryReport made{memory.name, kind_of(memory), memory.location, memory.depth, memory.width, 0, 0};
    for (const Block& block : process_.blocks)
      for (ValueId id : block.operations) {
        const Operation& op = process_[id];
        if (!op.is_memory_access() || op.object != index) continue;
        ++(op.kind == OpKind::kLoad ? made.loads : made.stores);
      }
    if (made.loads || made.stores) report_.memories.push_back(made);
  }

  static std::string kind_of(const Memory& memory) {
    switch (memory.kind) {
      case MemoryKind::kRegisters:
        return "registers";
      case MemoryKind::kRam:
        return "ram";
      case MemoryKind::kRom:
        return memory.load_latency ? "rom" : "logic";
      default:
        return "port";
    }
  }

  BlockReport block(int index) const {
    const Block& block = process_.blocks[index];
    const BlockSchedule& timing = schedule_.blocks[index];
    BlockReport made{block.name, block.location, block.is_loop, timing.ii, timing.length, {}};
    for (ValueId id : block.operations) {
      const Operation& op = process_[id];
      ScheduledOperation shown{id,
                               op.name,
                               operation_name(op.kind),
                               op.location,
                               op.bits,
                               schedule_.start[id],
                               schedule_.ready[id],
                               schedule_.begin[id],
                               schedule_.end[id],
                               {}};
      for (ValueId operand : op.operands)
        if (process_[operand].block == index) shown.operands.push_back(operand);
      if (op.predicate != kNoValue && process_[op.predicate].block == index)
        shown.operands.push_back(op.predicate);
      made.operations.push_back(shown);
    }
    return made;
  }

  /// Products and divisions by a constant, casts and shifts by a constant are no operators any more.
  static bool is_operator(const Process& process, const Operation& op) {
    switch (op.kind) {
      case OpKind::kShl:
      case OpKind::kLShr:
      case OpKind::kAShr:
        return process[op.operands[1]].kind != OpKind::kConstant;
      case OpKind::kAdd:
      case OpKind::kSub:
      case OpKind::kMul:
      case OpKind::kUDiv:
      case OpKind::kSDiv:
      case OpKind::kURem:
      case OpKind::kSRem:
      case OpKind::kCompare:
      case OpKind::kSelect:
        return true;
      default:
        return false;
    }
  }

  void count_operators() {
    std::map<std::pair<std::string, unsigned>, int> counts;
    for (const Block& block : process_.blocks)
      for (ValueId id : block.operations) {
        const Operation& op = process_[id];
        if (is_operator(process_, op)) ++counts[{operation_name(op.kind), width_of(op)}];
      }
    for (const auto& [key, count] : counts) report_.operators.push_back({key.first, key.second, count});
  }
  unsigned width_of(const Operation& op) const {
    if (op.kind != OpKind::kCompare) return op.bits;
    return std::max(process_[op.operands[0]].bits, process_[op.operands[1]].bits);
  }

  ChainReport longest_chain() const {
    ChainReport chain;
    ValueId last = kNoValue;
    for (size_t b = 0; b < process_.blocks.size(); ++b)
      for (ValueId id : process_.blocks[b].operations)
        if (last == kNoValue || schedule_.end[id] > chain.delay) {
          last = id;
          chain.delay = schedule_.end[id];
          chain.block = b;
        }
    for (; last != kNoValue; last = chained_operand(last)) chain.operations.push_back(last);
    std::reverse(chain.operations.begin(), chain.operations.end());
    return chain;
  }

  /// The operand that `id` waits for within its cycle, or kNoValue.
  ValueId chained_operand(ValueId id) const {
    constexpr double kSame = 1e-6;
    const Operation& op = process_[id];
    bool starts_at_register = schedule_.begin[id] < kSame || schedule_.ready[id] > schedule_.start[id];
    if (starts_at_register || op.kind == OpKind::kPhi) return kNoValue;
    std::vector<ValueId> operands = op.operands;
    operands.push_back(op.predicate);
    for (ValueId operand : operands)
      if (operand != kNoValue && process_[operand].block == op.block && operand != id &&
          schedule_.ready[operand] == schedule_.start[id] &&
          schedule_.end[operand] > schedule_.begin[id] - kSame)
        return operand;
    return kNoValue;
  }

  const Process& process_;
  const ProcessSchedule& schedule_;
  const ScheduleOptions& options_;
  ModuleReport report_;
};

}  // namespace

const char* operation_name(OpKind kind) {
  switch (kind) {
    case OpKind::kConstant:
      return "constant";
    case OpKind::kInput:
      return "input";
    case OpKind::kPhi:
      return "register";
    case OpKind::kAdd:
      return "add";
    case OpKind::kSub:
      return "subtract";
    case OpKind::kMul:
      return "multiply";
    case OpKind::kUDiv:
    case OpKind::kSDiv:
      return "divide";
    case OpKind::kURem:
    case OpKind::kSRem:
      return "remainder";
    case OpKind::kAnd:
      return "and";
    case OpKind::kOr:
      return "or";
    case OpKind::kXor:
      return "xor";
    case OpKind::kShl:
    case OpKind::kLShr:
    case OpKind::kAShr:
      return "shift";
    case OpKind::kCompare:
      return "compare";
    case OpKind::kSelect:
      return "select";
    case OpKind::kZExt:
    case OpKind::kSExt:
      return "extend";
    case OpKind::kTrunc:
      return "cut";
    case OpKind::kConcat:
      return "concatenate";
    case OpKind::kLoad:
      return "load";
    case OpKind::kStore:
      return "store";
    case OpKind::kRead:
      return "read";
    case OpKind::kWrite:
      return "write";
    case OpKind::kEmpty:
      return "is empty";
    case OpKind::kFull:
      return "is full";
    case OpKind::kOutput:
      return "output";
  }
  return "";
}

Report report_of(const CompileResult& result, const ScheduleOptions& options) {
  Report report;
  report.top = result.top.name;
  report.target = options.target.name;
  report.period = options.period;
  report.budget = options.period * (1 - options.margin);
  for (const CompiledProcess& compiled : result.processes) {
    report.modules.push_back(ModuleReporter(compiled, options).run());
    report.resources += report.modules.back().resources;
  }
  report.warnings = result.diagnostics.warnings;
  return report;
}

}  // namespace hlsc
