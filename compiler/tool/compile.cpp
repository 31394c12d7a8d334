#include "tool/compile.h"

#include "design/build.h"
#include "design/narrow.h"
#include "design/simplify.h"
#include "middle/pipeline.h"
#include "verilog/emit_process.h"

namespace hlsc {
namespace {

CompiledProcess compile_process(const Program& program, const MiddleResult& middle,
                                const std::string& function, const CompileOptions& options,
                                Diagnostics& diagnostics) {
  CompiledProcess result;
  result.process = build_process(program, middle, function, program.functions.at(function).name);
  narrow(result.process);
  forward_copies(result.process);
  ScheduleOptions schedule_options;
  schedule_options.target = target_named(options.target);
  schedule_options.period = options.period;
  result.schedule = schedule_process(result.process, schedule_options, diagnostics);
  return result;
}

}  // namespace

CompileResult compile(const CompileOptions& options) {
  CompileResult result;
  Program program = parse_program(options.frontend);
  MiddleResult middle = run_middle(program, result.diagnostics);
  auto top = program.functions.find(program.top);
  if (top == program.functions.end())
    throw CompileError("the parameters of '" + options.frontend.top +
                       "' have no hardware form; use integers, ap types, structs, arrays of known size and "
                       "hls::stream references");
  result.top = top->second;
  result.processes.push_back(compile_process(program, middle, program.top, options, result.diagnostics));
  for (const CompiledProcess& compiled : result.processes)
    result.files.push_back({compiled.process.name + ".v", emit_process(compiled.process, compiled.schedule)});
  return result;
}

}  // namespace hlsc
