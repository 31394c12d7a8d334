#include "tool/compile.h"

#include "design/aggregate.h"
#include "design/build.h"
#include "design/constant_multiply.h"
#include "design/dead.h"
#include "design/divide.h"
#include "design/exclusive.h"
#include "design/fold.h"
#include "design/names.h"
#include "design/narrow.h"
#include "design/share_loads.h"
#include "design/simplify.h"
#include "middle/pipeline.h"
#include "verilog/emit_process.h"
#include "verilog/emit_top.h"

namespace hlsc {
namespace {

class Compilation {
 public:
  Compilation(const CompileOptions& options, CompileResult& result)
      : options_(options),
        result_(result),
        program_(parse_program(options.frontend)),
        schedule_options_(schedule_options(options)) {}

  void run() {
    MiddleResult middle = run_middle(program_, result_.diagnostics);
    auto top = program_.functions.find(program_.top);
    if (top == program_.functions.end())
      throw CompileError("the parameters of '" + options_.frontend.top +
                         "' have no hardware form; use integers, ap types, structs, arrays of known size and "
                         "hls::stream references");
    result_.top = top->second;
    names_.unique(result_.top.name);
    bool is_region = middle.processes.size() > 1;
    for (const std::string& function : middle.processes) {
      bool is_top = function == program_.top;
      if (is_top && is_region) continue;
      std::string name = names_.unique(program_.functions.at(function).name + (is_top ? "_core" : ""));
      add_process(build_process(program_, middle, function, name));
    }
    PortModes modes = PortModes::from(middle.directives.ports[program_.top]);
    TopModule module = is_region ? region_top(middle, modes)
                                 : emit_single_top(result_.top, result_.processes[0].process, modes);
    result_.interface = module.interface;
    result_.files.push_back({result_.top.name + ".v", module.text});
  }

 private:
  CompiledProcess scheduled(Process process) {
    tell("build", process);
    share_loads(process);
    remove_dead(process);
    merge_exclusive_accesses(process);
    tell("merge accesses", process);
    narrow(process);
    tell("narrow", process);
    expand_divisions(process);
    expand_constant_products(process);
    tell("expand products and divisions", process);
    narrow(process);
    fold(process);
    forward_copies(process);
    remove_dead(process);
    join_aggregates(process, result_.diagnostics);
    tell("simplify", process);
    for (Memory& memory : process.memories)
      if (is_deep(schedule_options_.target, memory)) memory.load_latency = 2;
    CompiledProcess made{process, schedule_process(process, schedule_options_, result_.diagnostics)};
    tell("schedule", made.process, &made.schedule);
    return made;
  }

  void tell(const char* stage, const Process& process, const ProcessSchedule* schedule = nullptr) const {
    if (options_.on_stage) options_.on_stage(stage, process, schedule);
  }

  void add_process(Process process) {
    CompiledProcess compiled = scheduled(std::move(process));
    result_.files.push_back(
        {compiled.process.name + ".v", emit_process(compiled.process, compiled.schedule, options_.has_probes)});
    result_.processes.push_back(std::move(compiled));
  }

  TopModule region_top(const MiddleResult& middle, const PortModes& modes) {
    std::vector<Process> processes;
    for (const CompiledProcess& compiled : result_.processes) processes.push_back(compiled.process);
    Region region = build_region(program_, middle, processes);
    CompiledProcess head = scheduled(region.head);
    region.head = head.process;
    result_.files.push_back({head.process.name + ".v", is_combinational(head.process)
                                                           ? emit_combinational(head.process)
                                                           : emit_process(head.process, head.schedule, /*has_probes=*/false)});
    std::vector<const Process*> pointers;
    for (const CompiledProcess& compiled : result_.processes) pointers.push_back(&compiled.process);
    return emit_dataflow_top(result_.top, region, pointers, modes, options_.has_probes);
  }

  const CompileOptions& options_;
  CompileResult& result_;
  Program program_;
  ScheduleOptions schedule_options_;
  NameTable names_;
};

}  // namespace

ScheduleOptions schedule_options(const CompileOptions& options) {
  ScheduleOptions made;
  made.target = target_named(options.target);
  made.period = options.period;
  return made;
}

CompileResult compile(const CompileOptions& options) {
  CompileResult result;
  Compilation(options, result).run();
  const std::vector<std::string>& warnings = result.diagnostics.warnings;
  if (options.strict && !warnings.empty()) throw StrictWarning(warnings[0]);
  return result;
}

}  // namespace hlsc
