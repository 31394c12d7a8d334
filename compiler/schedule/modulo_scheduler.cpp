#include <algorithm>
#include <map>
#include <set>

#include "schedule/problem.h"

namespace hlsc {
namespace {

constexpr double kSlack = 1e-6;

/// Cycles from the start of a value to its use in a later iteration: it waits in a register, which is loaded
/// at the end of the cycle in which it is there.
int carried_gap(const ScheduleProblem& problem, const Dependence& dependence) {
  return dependence.is_data ? problem.operations[dependence.from].latency + 1 : dependence.min_cycles;
}

/// By operation: its dependences of distance 0.
using Incoming = std::vector<std::vector<size_t>>;

Incoming incoming_of(const ScheduleProblem& problem) {
  Incoming incoming(problem.operations.size());
  for (size_t i = 0; i < problem.dependences.size(); ++i)
    if (problem.dependences[i].distance == 0) incoming[problem.dependences[i].to].push_back(i);
  return incoming;
}

/// Places operations as soon as possible in their given order, then moves targets of violated carried
/// dependences later and repeats: the least fixed point of the difference constraints, with chaining and
/// resources kept exact in every round.
class AsapSolver {
 public:
  AsapSolver(const ScheduleProblem& problem, const Incoming& incoming, Schedule& schedule,
             ScheduleFailure& failure)
      : problem_(problem),
        incoming_(incoming),
        schedule_(schedule),
        failure_(failure),
        not_before_(problem.operations.size(), 0) {}

  /// From a solution: no operation comes earlier than there.
  void start_from(const std::vector<int>& cycles) { not_before_ = cycles; }

  bool run() {
    size_t count = problem_.operations.size();
    // A recurrence that fits needs each operation moved at most once per dependence; more means it does not
    // fit.
    int horizon = 4 * static_cast<int>(count) + 64;
    while (true) {
      if (!place_all(horizon)) return false;
      int violated = push_carried_targets();
      if (violated < 0) return true;
      if (not_before_[problem_.dependences[violated].to] > horizon) {
        failure_.dependence = violated;
        return false;
      }
    }
  }

 private:
  bool place_all(int horizon) {
    size_t count = problem_.operations.size();
    schedule_.cycle.assign(count, 0);
    schedule_.begin.assign(count, 0);
    schedule_.end.assign(count, 0);
    used_.assign(problem_.limits.size(), {});
    for (size_t op = 0; op < count; ++op)
      if (!place(op, horizon)) return false;
    return true;
  }

  bool place(int op, int horizon) {
    const ScheduleOperation& operation = problem_.operations[op];
    int cycle = not_before_[op];
    double begin = operation.launch;
    auto at_least = [&](int c, double t) {
      if (c > cycle) {
        cycle = c;
        begin = std::max(operation.launch, t);
      } else if (c == cycle) {
        begin = std::max(begin, t);
      }
    };
    for (size_t index : incoming_[op]) {
      const Dependence& dependence = problem_.dependences[index];
      int from_cycle = schedule_.cycle[dependence.from];
      if (dependence.is_data)
        at_least(from_cycle + problem_.operations[dependence.from].latency, schedule_.end[dependence.from]);
      else
        at_least(from_cycle + dependence.min_cycles, 0);
    }
    double needed = operation.delay + operation.tail;
    if (begin > operation.launch && begin + needed > problem_.period + kSlack) {
      ++cycle;
      begin = operation.launch;
    }
    for (int tries = 0; !is_free(operation.resource, cycle); ++tries) {
      if (cycle > horizon || (problem_.ii && tries > problem_.ii)) {
        failure_.resource = operation.resource;
        return false;
      }
      ++cycle;
      begin = operation.launch;
    }
    occupy(operation.resource, cycle);
    schedule_.cycle[op] = cycle;
    schedule_.begin[op] = begin;
    schedule_.end[op] =
        operation.latency ? operation.output_delay : std::max(operation.earliest, begin + operation.delay);
    return true;
  }

  int slot(int cycle) const { return problem_.ii ? cycle % problem_.ii : cycle; }
  bool is_free(int resource, int cycle) const {
    if (resource < 0) return true;
    auto found = used_[resource].find(slot(cycle));
    return found == used_[resource].end() || found->second < problem_.limits[resource];
  }
  void occupy(int resource, int cycle) {
    if (resource >= 0) ++used_[resource][slot(cycle)];
  }

  /// Moves targets of carried dependences that come too early; returns one that was violated, or -1.
  int push_carried_targets() {
    int violated = -1;
    for (size_t i = 0; i < problem_.dependences.size(); ++i) {
      const Dependence& dependence = problem_.dependences[i];
      if (dependence.distance == 0) continue;
      int gap = carried_gap(problem_, dependence);
      int earliest = schedule_.cycle[dependence.from] + gap - dependence.distance * problem_.ii;
      if (schedule_.cycle[dependence.to] >= earliest) continue;
      not_before_[dependence.to] = std::max(not_before_[dependence.to], earliest);
      violated = i;
    }
    return violated;
  }

  const ScheduleProblem& problem_;
  const Incoming& incoming_;
  Schedule& schedule_;
  ScheduleFailure& failure_;
  std::vector<int> not_before_;
  std::vector<std::map<int, int>> used_;
};

int length_of(const ScheduleProblem& problem, const Schedule& schedule) {
  int length = 0;
  for (size_t op = 0; op < problem.operations.size(); ++op)
    length = std::max(length, schedule.cycle[op] + problem.operations[op].latency + 1);
  return length;
}

/// Tries later cycles for one operation after the other, from the last to the first; what depends on it
/// moves along.
class RegisterSaver {
 public:
  RegisterSaver(const ScheduleProblem& problem, Schedule& schedule)
      : problem_(problem),
        incoming_(incoming_of(problem)),
        best_(schedule),
        bits_(register_bits(problem, schedule)) {
    length_ = length_of(problem, schedule);
    tries_left_ = kMostWork / std::max<size_t>(1, problem.operations.size());
  }

  void run() {
    for (bool improved = true; improved && tries_left_ > 0;) {
      improved = false;
      for (size_t op = problem_.operations.size(); op-- > 0;)
        if (!problem_.operations[op].is_fixed) improved |= delay(op);
    }
  }

 private:
  /// Operations placed in all tries: some tenths of a second.
  static constexpr size_t kMostWork = 4000000;

  bool delay(size_t op) {
    bool improved = false;
    std::vector<int> cycles = best_.cycle;
    while (++cycles[op] < length_ && tries_left_-- > 0) {
      Schedule tried;
      ScheduleFailure failure;
      AsapSolver solver(problem_, incoming_, tried, failure);
      solver.start_from(cycles);
      if (!solver.run() || !keeps_what_is_fixed(tried)) break;
      unsigned bits = register_bits(problem_, tried);
      if (bits >= bits_) continue;
      bits_ = bits;
      best_ = tried;
      cycles = tried.cycle;
      improved = true;
    }
    return improved;
  }

  bool keeps_what_is_fixed(const Schedule& tried) const {
    for (size_t op = 0; op < problem_.operations.size(); ++op)
      if (problem_.operations[op].is_fixed && tried.cycle[op] != best_.cycle[op]) return false;
    return length_of(problem_, tried) <= length_;
  }

  const ScheduleProblem& problem_;
  const Incoming incoming_;
  Schedule& best_;
  unsigned bits_;
  int length_;
  size_t tries_left_;
};

}  // namespace

void save_registers(const ScheduleProblem& problem, Schedule& schedule) {
  RegisterSaver(problem, schedule).run();
}

unsigned register_bits(const ScheduleProblem& problem, const Schedule& schedule) {
  const int ii = problem.ii;
  auto last_cycle = [&](int op) {
    const ScheduleOperation& operation = problem.operations[op];
    return schedule.cycle[op] + operation.latency + (operation.is_register ? ii - 1 : 0);
  };
  std::vector<int> last_use(problem.operations.size(), 0);
  std::set<std::pair<int, int>>
      taken;  // Operations, and when registers of the next iteration take their result.
  for (const Dependence& dependence : problem.dependences) {
    if (!dependence.is_data) continue;
    const ScheduleOperation &from = problem.operations[dependence.from],
                            &to = problem.operations[dependence.to];
    bool is_carried = dependence.distance > 0;  // Taken at the end of the cycle before.
    int use = schedule.cycle[dependence.to] + dependence.distance * ii - (is_carried ? 1 : 0);
    last_use[dependence.from] = std::max(last_use[dependence.from], use);
    if (dependence.distance == 1 && to.is_register && to.bits == from.bits)
      taken.insert({dependence.from, use});
  }
  unsigned bits = 0;
  for (size_t op = 0; op < problem.operations.size(); ++op) {
    int there = last_cycle(op), waits = last_use[op] - there;
    for (int copy = 0; copy * ii < waits; ++copy)
      if (!taken.count({op, there + copy * ii})) bits += problem.operations[op].bits;
  }
  return bits;
}

bool solve(const ScheduleProblem& problem, Schedule& schedule, ScheduleFailure& failure) {
  return AsapSolver(problem, incoming_of(problem), schedule, failure).run();
}

std::string verify(const ScheduleProblem& problem, const Schedule& schedule) {
  for (const Dependence& dependence : problem.dependences) {
    const ScheduleOperation& from = problem.operations[dependence.from];
    int start = schedule.cycle[dependence.from],
        end = schedule.cycle[dependence.to] + dependence.distance * problem.ii;
    int gap =
        dependence.is_data && dependence.distance == 0 ? from.latency : carried_gap(problem, dependence);
    if (end < start + gap)
      return "operation " + std::to_string(dependence.to) + " starts before its dependence on " +
             std::to_string(dependence.from);
    bool chained = dependence.is_data && dependence.distance == 0 && end == start + from.latency;
    if (chained && schedule.begin[dependence.to] + kSlack < schedule.end[dependence.from])
      return "operation " + std::to_string(dependence.to) + " starts before its operand " +
             std::to_string(dependence.from) + " is there: " + std::to_string(schedule.begin[dependence.to]) +
             " ns against " + std::to_string(schedule.end[dependence.from]) + " ns";
  }
  std::vector<std::map<int, int>> used(problem.limits.size());
  for (size_t op = 0; op < problem.operations.size(); ++op) {
    int resource = problem.operations[op].resource;
    if (resource < 0) continue;
    int slot = problem.ii ? schedule.cycle[op] % problem.ii : schedule.cycle[op];
    if (++used[resource][slot] > problem.limits[resource])
      return "resource " + std::to_string(resource) + " is used more often than it exists";
  }
  return "";
}

int resource_ii(const ScheduleProblem& problem) {
  std::vector<int> uses(problem.limits.size(), 0);
  for (const ScheduleOperation& operation : problem.operations)
    if (operation.resource >= 0) ++uses[operation.resource];
  int least = 1;
  for (size_t r = 0; r < uses.size(); ++r)
    least = std::max(least, (uses[r] + problem.limits[r] - 1) / problem.limits[r]);
  return least;
}

}  // namespace hlsc
