/// Schedules every block of a process and proves the result.
#ifndef HLSC_SCHEDULE_SCHEDULE_PROCESS_H
#define HLSC_SCHEDULE_SCHEDULE_PROCESS_H

#include <vector>

#include "design/design.h"
#include "schedule/delay_model.h"

namespace hlsc {

struct BlockSchedule {
  int ii = 0;  ///< Of a loop; 0 for a plain block.
  int wanted_ii = 0;
  int length = 1;            ///< Cycles of one run or iteration.
  std::string limit;         ///< Why ii is not the wanted one; empty when it is.
  int limiting_memory = -1;  ///< Whose port it is, if another would help.
};

struct ProcessSchedule {
  std::vector<BlockSchedule> blocks;
  std::vector<int> start;  ///< By ValueId: cycle in its block.
  std::vector<int> ready;  ///< By ValueId: cycle in which its result can be used.
  std::vector<double> begin, end;
  std::vector<int> port;  ///< By ValueId, of accesses of a memory outside: the number of its port.
};

struct ScheduleOptions {
  Target target;
  double period = 10;           ///< ns
  double margin = 0.2;          ///< Share of the period kept for routing and clock skew.
  bool saves_registers = true;  ///< Else operations stay as early as they can be: the same II in less time.
};

ProcessSchedule schedule_process(const Process& process, const ScheduleOptions& options,
                                 Diagnostics& diagnostics);

}  // namespace hlsc

#endif
