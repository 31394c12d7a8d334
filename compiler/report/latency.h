/// Cycles that a process takes, as a formula of the numbers of iterations that are not known.
#ifndef HLSC_REPORT_LATENCY_H
#define HLSC_REPORT_LATENCY_H

#include <map>
#include <string>
#include <vector>

#include "design/design.h"
#include "schedule/schedule_process.h"

namespace hlsc {

/// cycles + the sum of `terms`; without terms the number is exact, or a bound when it says so.
struct Latency {
  uint64_t cycles = 0;
  std::vector<std::string> terms;  ///< As "N(ROWS) * 12".
  bool is_bound = false;           ///< A branch or a break may make it less.
  bool is_endless = false;

  std::string text() const;
};

/// Latencies of a process and of its loops along the longest path, without stalls by streams.
class LatencyModel {
 public:
  LatencyModel(const Process& process, const ProcessSchedule& schedule);

  /// From the start to done.
  Latency process();
  /// One run of a loop.
  Latency loop(int index);

 private:
  /// The longest way from block `from` inside `loop` (-1: the whole process) to its end.
  Latency longest(int from, int loop);
  Latency block(int index) const;
  /// The loop directly inside `loop` whose header is `block`, or -1.
  int loop_entered(int block, int loop) const;
  bool contains(int loop, int block) const;
  /// The longest of the ways that go on at `targets`.
  Latency rest(const std::vector<int>& targets, int loop);

  const Process& process_;
  const ProcessSchedule& schedule_;
  std::map<std::pair<int, int>, Latency> longest_;  ///< By block and loop.
};

}  // namespace hlsc

#endif
