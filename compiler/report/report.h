/// What the compiler made of a program: loops, latency, memories, operators, estimates and the operations by
/// cycle, as plain values. report_text.h, report_json.h and report_page.h write it down.
#ifndef HLSC_REPORT_REPORT_H
#define HLSC_REPORT_REPORT_H

#include <string>
#include <vector>

#include "design/design.h"
#include "report/latency.h"
#include "report/resources.h"
#include "schedule/schedule_process.h"

namespace hlsc {

struct CompileResult;

/// A loop of the source.
struct LoopReport {
  std::string name;
  SourceLocation location;
  int depth_in_nest = 0;  ///< 0: no loop around it.
  bool is_pipelined = false;
  int asked_ii = 0, ii = 0;  ///< Of a pipelined loop.
  std::string limit;  ///< What keeps ii above the asked one, with source lines; empty when nothing does.
  int stages = 0;     ///< Cycles of one iteration of a pipelined loop.
  uint64_t least_trips = 0, most_trips = 0;  ///< As in SourceLoop.
  Latency latency;                           ///< Cycles of one run of the loop.
};

struct MemoryReport {
  std::string name, kind;  ///< Kind: "registers", "ram", "rom", "logic" (a table without a clock), "port".
  SourceLocation location;
  uint64_t words = 0;
  unsigned bits = 0;          ///< Of a word.
  int loads = 0, stores = 0;  ///< Operations that share the ports.
};

/// Equal operators, counted.
struct OperatorReport {
  std::string kind;
  unsigned bits = 0;
  int count = 0;
};

/// An operation as the schedule viewer shows it. Times are ns within their cycle.
struct ScheduledOperation {
  ValueId id = kNoValue;
  std::string name, kind;
  SourceLocation location;
  unsigned bits = 0;
  int start = 0, ready = 0;  ///< Cycles in the block.
  double begin = 0, end = 0;
  std::vector<ValueId> operands;
};

struct BlockReport {
  std::string name;
  SourceLocation location;
  bool is_loop = false;
  int ii = 0, cycles = 0;
  std::vector<ScheduledOperation> operations;
};

/// The longest chain of operations between two clock edges.
struct ChainReport {
  double delay = 0;                 ///< ns
  std::vector<ValueId> operations;  ///< From the register on.
  int block = -1;
};

struct ModuleReport {
  std::string name, source_name;
  SourceLocation location;
  Latency latency;  ///< From start to done, without stalls.
  std::vector<LoopReport> loops;
  std::vector<MemoryReport> memories;
  std::vector<OperatorReport> operators;
  std::vector<BlockReport> blocks;
  Resources resources;
  ChainReport chain;
};

struct Report {
  std::string top, target;
  double period = 0, budget = 0;  ///< ns: of the clock, and what a chain may take of it.
  std::vector<ModuleReport> modules;
  Resources resources;  ///< Of all modules, without the FIFOs between them.
  std::vector<std::string> warnings;
};

/// Everything that can be said of `result`, which was compiled for `options`.
Report report_of(const CompileResult& result, const ScheduleOptions& options);

/// "sum", "product", ... as a reader calls the operation.
const char* operation_name(OpKind kind);

}  // namespace hlsc

#endif
