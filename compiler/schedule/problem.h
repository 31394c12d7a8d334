/// A scheduling problem as a value, its solution, and the check that the one solves the other.
///
/// Operations start in a cycle and, chained behind others, at a time within the cycle. In a pipelined problem
/// an operation of iteration i that starts in cycle c runs at clock i * ii + c. A dependence with distance d
/// leads to the iteration d later.
#ifndef HLSC_SCHEDULE_PROBLEM_H
#define HLSC_SCHEDULE_PROBLEM_H

#include <string>
#include <vector>

namespace hlsc {

struct ScheduleOperation {
  double delay = 0;         ///< ns from inputs to output; of latency 0 operations.
  double output_delay = 0;  ///< ns from the clock edge to the output; of operations with latency.
  double earliest =
      0;  ///< ns after the clock edge before which its output is not there (registers, FIFO outputs).
  double launch = 0;         ///< ns after the clock edge before which no operand is there.
  double tail = 0;           ///< ns that must remain in the cycle behind it (stall logic of a stream access).
  int latency = 0;           ///< Cycles from start to output.
  int resource = -1;         ///< Index into limits; -1: none.
  unsigned bits = 0;         ///< Of the result, when it takes a register to carry it to a later cycle.
  bool is_register = false;  ///< The result stays for ii cycles by itself.
  bool is_fixed = false;     ///< Seen from outside when it happens: stays where the solution puts it.
};

struct Dependence {
  int from = 0, to = 0;
  int distance = 0;     ///< Iterations.
  bool is_data = true;  ///< The value flows: latency and chaining count. Else only min_cycles counts.
  int min_cycles = 0;   ///< Of an order dependence: start(to) + distance * ii >= start(from) + min_cycles.
};

struct ScheduleProblem {
  std::vector<ScheduleOperation>
      operations;  ///< In an order in which dependences of distance 0 lead forward.
  std::vector<Dependence> dependences;
  std::vector<int> limits;  ///< Uses of each resource per cycle.
  double period = 10;       ///< ns a chain may take.
  int ii = 0;               ///< 0: not pipelined.
};

struct Schedule {
  std::vector<int> cycle;
  std::vector<double> begin, end;  ///< ns within the start cycle (begin) and the output's cycle (end).
};

/// Why there is no schedule: a dependence of a recurrence, or a resource.
struct ScheduleFailure {
  int dependence = -1;
  int resource = -1;
};

/// Solves `problem`. Returns false and the cause when its ii is too small.
bool solve(const ScheduleProblem& problem, Schedule& schedule, ScheduleFailure& failure);

/// Moves operations of a pipelined problem to later cycles where values then wait in fewer registers. The
/// length of the schedule and the cycles of fixed operations stay.
void save_registers(const ScheduleProblem& problem, Schedule& schedule);

/// Register bits that carry values of a pipelined problem from cycle to cycle. A register that takes a value
/// for the next iteration as soon as it would be copied holds it for this one, too.
unsigned register_bits(const ScheduleProblem& problem, const Schedule& schedule);

/// Empty when `schedule` obeys every dependence, limit and period of `problem`; else what it breaks.
std::string verify(const ScheduleProblem& problem, const Schedule& schedule);

/// A lower bound of ii from the resources alone.
int resource_ii(const ScheduleProblem& problem);

}  // namespace hlsc

#endif
