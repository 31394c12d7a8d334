/// The whole compiler as one call: sources in, Verilog modules and a description of the top out.
#ifndef HLSC_TOOL_COMPILE_H
#define HLSC_TOOL_COMPILE_H

#include <functional>
#include <string>
#include <vector>

#include "design/design.h"
#include "frontend/frontend.h"
#include "schedule/schedule_process.h"
#include "verilog/interface.h"

namespace hlsc {

/// Called with a process as a stage of the compiler leaves it; the schedule is null before there is one.
using StageObserver =
    std::function<void(const std::string& stage, const Process& process, const ProcessSchedule* schedule)>;

struct CompileOptions {
  FrontendOptions frontend;
  std::string target = "xc7";
  double period = 10;             ///< ns
  bool strict = false;            ///< The first warning is an error.
  std::vector<std::string> taps;  ///< Streams between the processes that get outputs to look at them.
  StageObserver on_stage;         ///< May be empty.
  bool has_probes = false;        ///< The modules tell a co-simulation what they do (verilog/emit_probes.h).
};

/// One generated file.
struct GeneratedFile {
  std::string name;
  std::string text;
};

struct CompiledProcess {
  Process process;
  ProcessSchedule schedule;
};

struct CompileResult {
  std::vector<GeneratedFile> files;
  std::vector<CompiledProcess>
      processes;  ///< Of a dataflow region in the order of their calls; else the top alone.
  FunctionInfo top;
  TopInterface interface;
  Diagnostics diagnostics;
};

/// Throws CompileError for an unknown target.
ScheduleOptions schedule_options(const CompileOptions& options);

/// Throws CompileError.
CompileResult compile(const CompileOptions& options);

}  // namespace hlsc

#endif
