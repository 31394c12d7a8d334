/// The whole compiler as one call: sources in, Verilog modules and a description of the top out.
#ifndef HLSC_TOOL_COMPILE_H
#define HLSC_TOOL_COMPILE_H

#include <string>
#include <vector>

#include "design/design.h"
#include "frontend/frontend.h"
#include "schedule/schedule_process.h"
#include "verilog/interface.h"

namespace hlsc {

struct CompileOptions {
  FrontendOptions frontend;
  std::string target = "xc7";
  double period = 10;   ///< ns
  bool strict = false;  ///< The first warning is an error.
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
