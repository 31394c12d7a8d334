#include "schedule/schedule_process.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "design/exclusive.h"
#include "schedule/problem.h"

namespace hlsc {
namespace {

/// Of a written loop: it is then better none. Calls have the II that they need.
constexpr int kMaxIi = 256;
constexpr int kDeepestAddress = 8;     ///< Operations in each other that are looked through.
constexpr unsigned kWideAddress = 20;  ///< Bits that no loop's counter runs through.

/// Resources of a process: a read and a write port per memory, or two ports for both; one access a cycle per
/// stream.
class Resources {
 public:
  enum Kind { kStream, kRead, kWrite, kAnyPort };

  int of(const Process& process, const Operation& op) {
    if (op.is_stream_access()) return index({kStream, op.object});
    if (!op.is_memory_access()) return -1;
    const Memory& memory = process.memories[op.object];
    if (memory.kind == MemoryKind::kRegisters ||
        (memory.kind == MemoryKind::kRom && memory.load_latency == 0))
      return -1;
    if (memory.has_two_ports) return index({kAnyPort, op.object});
    return index({op.kind == OpKind::kLoad ? kRead : kWrite, op.object});
  }
  std::vector<int> limits() const {
    std::vector<int> limits(indices_.size(), 1);
    for (const auto& [key, value] : indices_)
      if (key.first == kAnyPort) limits[value] = 2;
    return limits;
  }
  /// The memory of which the resource is a port that may be doubled; -1: another resource.
  int memory_to_widen(const Process& process, int resource) const {
    for (const auto& [key, value] : indices_)
      if (value == resource &&
          (key.first == kRead || (key.first == kWrite && process.memories[key.second].may_have_two_ports)))
        return key.second;
    return -1;
  }
  std::string name(const Process& process, int resource) const {
    for (const auto& [key, value] : indices_) {
      if (value != resource) continue;
      if (key.first == kStream) return "stream '" + process.streams[key.second].name + "'";
      std::string of = " of '" + process.memories[key.second].name + "'";
      if (key.first == kAnyPort) return "pair of ports" + of;
      return (key.first == kRead ? "read port" : "write port") + of;
    }
    return "";
  }

 private:
  int index(std::pair<Kind, int> key) { return indices_.emplace(key, indices_.size()).first->second; }
  std::map<std::pair<Kind, int>, int> indices_;
};

class BlockScheduler {
 public:
  BlockScheduler(const Process& process, int block, const ScheduleOptions& options)
      : process_(process), block_(process.blocks[block]), block_id_(block), options_(options) {
    for (size_t i = 0; i < block_.operations.size(); ++i) node_[block_.operations[i]] = i;
    build_operations();
    add_data_dependences();
    add_memory_dependences();
    add_stream_dependences();
    add_status_dependences();
    add_output_dependences();
    add_lock_dependences();
    add_exit_dependences();
    problem_.limits = resources_.limits();
  }

  void run(ProcessSchedule& result, Diagnostics& diagnostics) {
    BlockSchedule& summary = result.blocks[block_id_];
    Schedule schedule;
    ScheduleFailure failure;
    if (!block_.is_loop) {
      if (!solve(problem_, schedule, failure))
        throw CompileError(block_.location,
                           "internal: no schedule for straight code; please report this program");
    } else {
      int wanted = std::max(1, block_.wanted_ii);
      problem_.ii = wanted;
      summary.wanted_ii = wanted;
      while (!solve(problem_, schedule, failure)) {
        if (summary.limit.empty()) {
          summary.limit = explain(failure);
          summary.limiting_memory = resources_.memory_to_widen(process_, failure.resource);
        }
        raise_ii();
        if (problem_.ii > kMaxIi && !block_.takes_calls)
          throw CompileError(block_.location, "the loop has no schedule with an II up to " +
                                                  std::to_string(kMaxIi) + ": " + summary.limit);
      }
      if (options_.saves_registers) save_registers(problem_, schedule);
      summary.ii = problem_.ii;
      if (block_.wanted_ii && summary.ii > wanted)
        diagnostics.warn(block_.location, "II = " + std::to_string(wanted) + " is not reached, II is " +
                                              std::to_string(summary.ii) + ": " + summary.limit);
    }
    std::string fault = verify(problem_, schedule);
    if (!fault.empty())
      throw CompileError(block_.location,
                         "internal: wrong schedule (" + fault + "); please report this program");
    record(schedule, result, summary);
  }

 private:
  /// To the next II that may do; calls that take long have one to a sixteenth more than the least.
  void raise_ii() {
    problem_.ii += block_.takes_calls ? 1 + problem_.ii / 16 : 1;
    if (block_.takes_calls) problem_.ii = std::max(problem_.ii, resource_ii(problem_));
  }

  void build_operations() {
    for (ValueId id : block_.operations) {
      const Operation& op = process_[id];
      ScheduleOperation node;
      node.resource = resources_.of(process_, op);
      node.delay = delay_of(options_.target, process_, op);
      node.earliest = options_.target.registers;
      node.launch = options_.target.launch;
      if (op.kind == OpKind::kLoad && process_.memories[op.object].load_latency > 0) {
        node.latency = process_.memories[op.object].load_latency;
        node.delay = 0;
        node.output_delay = output_delay(process_.memories[op.object]);
        if (is_lut_ram(options_.target, process_.memories[op.object]))
          node.tail = lut_ram_read(options_.target, process_.memories[op.object]);
      }
      if (op.is_memory_access() && is_far(op)) node.tail = options_.target.reach;
      if (op.kind == OpKind::kStore && op.predicate != kNoValue && !is_far(op) && node.resource >= 0)
        node.tail = options_.target.enable;
      if (op.is_stream_access()) node.tail = options_.target.stall;
      if (id == block_.terminator.condition && !block_.is_loop) node.tail = options_.target.enable;
      node.bits = op.has_result() && op.kind != OpKind::kConstant ? op.bits : 0;
      node.is_register = op.kind == OpKind::kPhi;
      node.is_fixed = op.has_effect() || op.kind == OpKind::kEmpty || op.kind == OpKind::kFull ||
                      op.kind == OpKind::kInput || id == block_.terminator.condition;
      problem_.operations.push_back(node);
    }
    problem_.period = options_.period * (1 - options_.margin);
  }

  double output_delay(const Memory& memory) const {
    const Target& target = options_.target;
    if (memory.load_latency > 1) return target.registers + 2 * target.logic;
    return is_lut_ram(target, memory) ? target.registers : target.memory;
  }

  bool is_far(const Operation& access) const { return process_.memories[access.object].load_latency > 1; }

  void data(ValueId from, int to, int distance = 0) {
    auto found = node_.find(from);
    if (found == node_.end()) return;
    Dependence dependence;
    dependence.from = found->second;
    dependence.to = to;
    dependence.distance = distance;
    problem_.dependences.push_back(dependence);
  }

  void order(int from, int to, int distance, int min_cycles) {
    Dependence dependence;
    dependence.from = from;
    dependence.to = to;
    dependence.distance = distance;
    dependence.is_data = false;
    dependence.min_cycles = min_cycles;
    problem_.dependences.push_back(dependence);
  }

  void add_data_dependences() {
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      const Operation& op = process_[block_.operations[i]];
      if (op.kind == OpKind::kPhi) {
        for (size_t k = 0; k < op.operands.size(); ++k)
          if (block_.is_loop && block_.predecessors[k] == block_id_) data(op.operands[k], i, 1);
        continue;
      }
      for (ValueId operand : op.operands) data(operand, i);
      if (op.predicate != kNoValue) data(op.predicate, i);
    }
  }

  /// Constant difference of two addresses, when known: then equal or never equal in one iteration.
  bool differ(const Operation& a, const Operation& b) const {
    const Operation &x = process_[a.operands[0]], &y = process_[b.operands[0]];
    return x.kind == OpKind::kConstant && y.kind == OpKind::kConstant &&
           x.constant.getZExtValue() != y.constant.getZExtValue();
  }

  /// An address as a sum: scale * phi + offset + values that are the same in every iteration.
  struct Affine {
    bool is_known = false;  ///< It is such a sum.
    ValueId phi = kNoValue;
    int64_t scale = 0, offset = 0;
    std::map<ValueId, int64_t> invariants;  ///< By value: its factor.

    /// Whether both differ by a constant in an iteration.
    bool is_parallel(const Affine& other) const {
      return is_known && other.is_known && phi == other.phi && scale == other.scale &&
             invariants == other.invariants;
    }
  };
  Affine affine(ValueId id) const {
    Affine form;
    form.is_known = add_terms(id, 1, form, 0);
    return form;
  }

  bool add_terms(ValueId id, int64_t scale, Affine& form, int depth) const {
    const Operation& op = process_[id];
    bool is_leaf = depth > kDeepestAddress, is_inside = node_.count(id);
    std::optional<int64_t> factor = is_leaf ? std::nullopt : constant_factor(op);
    if (op.kind == OpKind::kConstant) {
      form.offset += scale * op.constant.getSExtValue();
    } else if (!is_leaf && (op.kind == OpKind::kAdd || is_sum_without_carry(op))) {
      return add_terms(op.operands[0], scale, form, depth + 1) &&
             add_terms(op.operands[1], scale, form, depth + 1);
    } else if (factor) {
      return add_terms(op.operands[0], scale * *factor, form, depth + 1);
    } else if (!is_inside) {
      form.invariants[id] += scale;
    } else if (op.kind == OpKind::kPhi && (form.phi == kNoValue || form.phi == id)) {
      form.phi = id;
      form.scale += scale;
    } else {
      return false;
    }
    return true;
  }

  /// 2 * i + 1 is written as 2 * i | 1: a constant below the lowest bit of a multiple.
  bool is_sum_without_carry(const Operation& op) const {
    if (op.kind != OpKind::kOr) return false;
    const Operation& right = process_[op.operands[1]];
    std::optional<int64_t> factor = constant_factor(process_[op.operands[0]]);
    if (right.kind != OpKind::kConstant || !factor || *factor <= 0) return false;
    uint64_t lowest = static_cast<uint64_t>(*factor & -*factor);
    return right.constant.ult(lowest);
  }

  /// By what an operation multiplies its first operand, if by a small constant.
  std::optional<int64_t> constant_factor(const Operation& op) const {
    if (op.kind == OpKind::kZExt || op.kind == OpKind::kSExt) return 1;
    if ((op.kind != OpKind::kShl && op.kind != OpKind::kMul) || op.type_width < kWideAddress)
      return std::nullopt;
    const Operation& right = process_[op.operands[1]];
    if (right.kind != OpKind::kConstant) return std::nullopt;
    uint64_t number = right.constant.getLimitedValue(), limit = uint64_t{1} << kWideAddress;
    if (op.kind == OpKind::kShl) number = number < kWideAddress ? uint64_t{1} << number : limit;
    return number < limit ? std::optional<int64_t>(number) : std::nullopt;
  }

  /// Step per iteration of a phi that counts, or 0.
  int64_t step_of(ValueId phi) const {
    const Operation& op = process_[phi];
    for (size_t k = 0; k < op.operands.size(); ++k) {
      if (block_.predecessors[k] != block_id_) continue;
      Affine next = affine(op.operands[k]);
      return next.is_known && next.phi == phi && next.scale == 1 && next.invariants.empty() ? next.offset : 0;
    }
    return 0;
  }

  /// Iterations from `from` to the next one in which `to` may touch the same word; 0: never.
  int carried_distance(const Operation& from, const Operation& to) const {
    if (differ(from, to)) return 0;
    Affine a = affine(from.operands[0]), b = affine(to.operands[0]);
    if (a.phi == kNoValue || !a.is_parallel(b)) return 1;
    unsigned width = process_[a.phi].type_width;
    if (a.scale != 1 && width < kWideAddress) return 1;
    int64_t step = step_of(a.phi) * a.scale;
    if (step == 0) return 1;
    // phi + a == (phi + d * step) + b, exactly or modulo the counter's width.
    int64_t gap = a.offset - b.offset;
    if (step < 0) {
      step = -step;
      gap = -gap;
    }
    const int64_t never = int64_t{1} << 20;
    int64_t distance = gap % step == 0 && gap / step >= 1 ? gap / step : never;
    if (width < kWideAddress) {
      int64_t modulus = int64_t{1} << width, wrapped = ((gap % modulus) + modulus) % modulus;
      distance = std::min(distance, std::max<int64_t>(1, (wrapped ? wrapped : modulus) / step));
    }
    return distance == never ? 0 : static_cast<int>(std::min(distance, never));
  }

  bool is_claimed_apart(const Operation& from, const Operation& to) const {
    return block_.is_loop &&
           llvm::any_of(process_.memories[from.object].claims, [&](const DependenceClaim& claim) {
             return claim.in_iteration && block_.has(claim) && claim.covers(from, to);
           });
  }

  /// As far as DEPENDENCE knows more than the subscripts tell.
  int claimed_distance(const Operation& from, const Operation& to, int distance) const {
    for (const DependenceClaim& claim : process_.memories[from.object].claims)
      if (!claim.in_iteration && block_.has(claim) && claim.covers(from, to))
        distance = claim.distance && distance ? std::max(distance, claim.distance) : 0;
    return distance;
  }

  bool differ_in_iteration(const Operation& a, const Operation& b) const {
    if (differ(a, b) || are_set_apart(process_, a, b)) return true;
    Affine x = affine(a.operands[0]), y = affine(b.operands[0]);
    return x.phi != kNoValue && x.is_parallel(y) && x.offset != y.offset;
  }

  /// Cycles from one access to a later one of the same word, which may lie in a later iteration.
  int gap(const Operation& first, const Operation& second, bool is_carried) const {
    bool immediate = process_.memories[first.object].kind == MemoryKind::kRegisters;
    if (first.kind == OpKind::kLoad)
      return immediate ? 0 : 1;  // A RAM read of the word being written is undefined.
    // Of an iteration's stores to a register in one cycle the last stands last in the Verilog, too.
    bool overwrites = immediate && block_.is_loop && !is_carried && second.kind == OpKind::kStore;
    return overwrites ? 0 : 1;
  }

  void add_memory_dependences() {
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      const Operation& first = process_[block_.operations[i]];
      if (!first.is_memory_access()) continue;
      for (size_t k = 0; k < block_.operations.size(); ++k) {
        const Operation& second = process_[block_.operations[k]];
        if (!second.is_memory_access() || second.object != first.object) continue;
        if (first.kind == OpKind::kLoad && second.kind == OpKind::kLoad) continue;
        if (i < k && !differ_in_iteration(first, second) && !is_claimed_apart(first, second))
          order(i, k, 0, gap(first, second, false));
        if (!block_.is_loop) continue;
        int distance = claimed_distance(first, second, carried_distance(first, second));
        if (distance > 0) order(i, k, distance, gap(first, second, true));
      }
    }
  }

  void add_stream_dependences() {
    // A call ends for itself, while the iterations of a loop written in the source may wait for each other.
    const bool in_sequence = !block_.is_loop || block_.takes_calls;
    int last_write = -1, last_access = -1;
    std::map<int, std::pair<int, int>> ends;  // stream -> first and last access
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      const Operation& op = process_[block_.operations[i]];
      if (!op.is_stream_access()) continue;
      auto [place, is_new] = ends.emplace(op.object, std::make_pair(i, i));
      if (!is_new) {
        order(place->second.second, i, 0, 1);
        place->second.second = i;
      }
      if (in_sequence && last_access >= 0) order(last_access, i, 0, 0);
      // A partner may answer the write with what is read next.
      if (in_sequence && op.kind == OpKind::kRead && last_write >= 0) order(last_write, i, 0, 1);
      if (op.kind == OpKind::kWrite) last_write = i;
      last_access = i;
    }
    if (block_.is_loop)
      for (const auto& [stream, pair] : ends) order(pair.second, pair.first, 1, 1);
  }

  /// What empty() or full() told holds until the access behind it: no other access may come between.
  void add_status_dependences() {
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      const Operation& status = process_[block_.operations[i]];
      if (status.kind != OpKind::kEmpty && status.kind != OpKind::kFull) continue;
      for (size_t k = 0; k < block_.operations.size(); ++k) {
        const Operation& access = process_[block_.operations[k]];
        if (!access.is_stream_access() || access.object != status.object) continue;
        i < k ? order(i, k, 0, 0) : order(k, i, 0, 1);
        if (block_.is_loop) order(k, i, 1, 1);
      }
    }
  }

  /// What a scalar port is set to last stays.
  void add_output_dependences() {
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      const Operation& first = process_[block_.operations[i]];
      if (first.kind != OpKind::kOutput) continue;
      for (size_t k = i; k < block_.operations.size(); ++k) {
        const Operation& second = process_[block_.operations[k]];
        if (second.kind != OpKind::kOutput || second.object != first.object) continue;
        if (i < k) order(i, k, 0, 0);
        if (block_.is_loop) order(k, i, 1, 1);
      }
    }
  }

  /// A memory's accesses stay between the tokens that take and give it.
  void add_lock_dependences() {
    if (llvm::none_of(process_.streams, [](const Stream& stream) { return stream.is_lock; })) return;
    auto touches = [&](const Operation& a, const Operation& b) {
      bool is_other_lock =
          a.is_stream_access() && b.is_stream_access() && process_.streams[a.object].is_lock &&
          process_.streams[a.object].llvm_argument == process_.streams[b.object].llvm_argument;
      return is_other_lock || (b.is_memory_access() && process_.guards(a, b.object));
    };
    for (size_t i = 0; i < block_.operations.size(); ++i)
      for (size_t k = i + 1; k < block_.operations.size(); ++k) {
        const Operation &first = process_[block_.operations[i]], &second = process_[block_.operations[k]];
        if (!touches(first, second) && !touches(second, first)) continue;
        order(i, k, 0, 1);
        if (block_.is_loop) order(k, i, 1, 1);
      }
  }

  /// The next iteration may act only when this one is known not to leave the loop.
  void add_exit_dependences() {
    if (!block_.is_loop || block_.terminator.condition == kNoValue) return;
    auto condition = node_.find(block_.terminator.condition);
    if (condition == node_.end()) return;
    for (size_t i = 0; i < block_.operations.size(); ++i)
      if (process_[block_.operations[i]].has_effect())
        order(condition->second, i, 1, 1 + problem_.operations[condition->second].latency);
  }

  std::string explain(const ScheduleFailure& failure) const {
    if (failure.resource >= 0) {
      std::string users;
      std::set<std::string> places;
      for (size_t i = 0; i < problem_.operations.size(); ++i) {
        std::string place = process_[block_.operations[i]].location.text();
        if (problem_.operations[i].resource == failure.resource && places.insert(place).second)
          users += (users.empty() ? "" : ", ") + place;
      }
      return "the " + resources_.name(process_, failure.resource) + " is used at " + users +
             "; partition the array or access it once an iteration";
    }
    const Dependence& dependence = problem_.dependences[failure.dependence];
    const Operation &from = process_[block_.operations[dependence.from]],
                    &to = process_[block_.operations[dependence.to]];
    return "'" + from.name + "' (" + from.location.text() + ") must be ready for '" + to.name + "' (" +
           to.location.text() + ") of " + std::to_string(dependence.distance) +
           (block_.takes_calls ? " call" : " iteration") + (dependence.distance == 1 ? "" : "s") +
           " later; shorten the path between them";
  }

  void record(const Schedule& schedule, ProcessSchedule& result, BlockSchedule& summary) {
    int length = 1;
    for (size_t i = 0; i < block_.operations.size(); ++i) {
      ValueId id = block_.operations[i];
      result.start[id] = schedule.cycle[i];
      result.ready[id] = schedule.cycle[i] + problem_.operations[i].latency;
      result.begin[id] = schedule.begin[i];
      result.end[id] = schedule.end[i];
      length = std::max(length, result.ready[id] + 1);
    }
    summary.length = block_.is_loop ? std::max(length, summary.ii) : length;
    choose_ports(result);
  }

  /// Of what happens in one cycle, loads take ports from the first on, and stores from the last on where
  /// there are loads: so an array that is read and written in turns has one port for each.
  void choose_ports(ProcessSchedule& result) const {
    std::map<std::pair<int, int>, int> loads, stores;
    for (ValueId id : block_.operations) {
      const Operation& op = process_[id];
      if (!op.is_memory_access()) continue;
      const Memory& memory = process_.memories[op.object];
      int cycle = problem_.ii ? result.start[id] % problem_.ii : result.start[id];
      bool is_load = op.kind == OpKind::kLoad;
      int before = memory.has_two_ports ? (is_load ? loads : stores)[{op.object, cycle}]++ : 0;
      result.port[id] = !is_load && memory.is_read ? 1 - before : before;
    }
  }

  const Process& process_;
  const Block& block_;
  int block_id_;
  const ScheduleOptions& options_;
  std::map<ValueId, int> node_;
  Resources resources_;
  ScheduleProblem problem_;
};

}  // namespace

ProcessSchedule schedule_process(const Process& process, const ScheduleOptions& options,
                                 Diagnostics& diagnostics) {
  ProcessSchedule result;
  result.blocks.resize(process.blocks.size());
  size_t count = process.operations.size();
  result.start.assign(count, 0);
  result.ready.assign(count, 0);
  result.begin.assign(count, 0);
  result.end.assign(count, 0);
  result.port.assign(count, 0);
  for (size_t block = 0; block < process.blocks.size(); ++block)
    BlockScheduler(process, block, options).run(result, diagnostics);
  return result;
}

}  // namespace hlsc
