#include "tool/compile.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "design/aggregate.h"
#include "design/build.h"
#include "design/constant_multiply.h"
#include "design/copy_memory.h"
#include "design/count_down.h"
#include "design/dead.h"
#include "design/divide.h"
#include "design/exclusive.h"
#include "design/fold.h"
#include "design/names.h"
#include "design/narrow.h"
#include "design/share_loads.h"
#include "design/simplify.h"
#include "design/split_products.h"
#include "middle/llvm_headers.h"
#include "middle/pipeline.h"
#include "report/latency.h"
#include "verilog/emit_process.h"
#include "verilog/emit_top.h"

namespace hlsc {
namespace {

/// Places of loops in the source, as text.
using Places = std::set<std::string>;

/// One pass through the compiler.
class Compilation {
 public:
  /// `apart`: loops that are not flattened. `in_sequence`: DATAFLOW functions run as they are written.
  Compilation(const CompileOptions& options, const Places& apart, bool in_sequence)
      : options_(options),
        apart_(apart),
        in_sequence_(in_sequence),
        program_(parse_program(options.frontend)),
        schedule_options_(schedule_options(options)) {}

  void run() {
    MiddleResult middle = run_middle(
        program_, [&](const SourceLocation& place) { return apart_.count(place.text()) > 0; }, in_sequence_,
        result_.diagnostics);
    for (const SourceLocation& place : middle.flattened) flattened_.insert(place.text());
    auto top = program_.functions.find(program_.top);
    if (top == program_.functions.end()) throw CompileError(program_.top_problem);
    result_.top = top->second;
    if (is_keyword(result_.top.name))
      throw CompileError(
          result_.top.location,
          "'" + result_.top.name + "' is a word of Verilog and cannot name the top; rename it");
    names_.unique(result_.top.name);
    bool is_region = middle.processes.size() > 1;
    if (!is_region && !options_.taps.empty())
      throw CompileError("'" + program_.top + "' is a single process: there is no stream inside to tap");
    for (const std::string& function : middle.processes) {
      bool is_top = function == program_.top;
      if (is_top && is_region) continue;
      std::string name = names_.unique(program_.functions.at(function).name + (is_top ? "_core" : ""));
      add_process(build_process(program_, middle, function, name), function);
    }
    PortModes modes = PortModes::from(middle.directives.ports[program_.top], result_.diagnostics);
    modes.least_fifo = schedule_options_.target.least_fifo;
    TopModule module =
        is_region ? region_top(middle, modes)
                  : emit_single_top(result_.top, result_.processes[0].process, modes, options_.has_probes);
    result_.interface = module.interface;
    result_.files.push_back({result_.top.name + ".v", module.text});
    for (const auto& [name, text] : module.bank_files) result_.files.push_back({name, text});
  }

  CompileResult& result() { return result_; }

  /// The greatest II of the pipelined loops that begin at `place`, and the II asked for.
  std::pair<int, int> interval(const std::string& place) const {
    std::pair<int, int> found{0, 1};
    for (const CompiledProcess& compiled : result_.processes)
      for (size_t i = 0; i < compiled.process.blocks.size(); ++i) {
        const Block& block = compiled.process.blocks[i];
        if (block.is_loop && block.location.text() == place)
          found = std::max(found, {compiled.schedule.blocks[i].ii, std::max(1, block.wanted_ii)});
      }
    return found;
  }

  /// Flattened loops that do not reach their II.
  Places slow_nests() const {
    Places slow;
    for (const std::string& place : flattened_)
      if (auto [ii, asked] = interval(place); ii > asked) slow.insert(place);
    return slow;
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
    const Target& target = schedule_options_.target;
    if (!target.adds_products) split_products(process, target.multiplier_narrow);
    tell("expand products and divisions", process);
    narrow(process);
    fold(process);
    forward_copies(process);
    count_down(process);
    remove_dead(process);
    join_aggregates(process, result_.diagnostics);
    tell("simplify", process);
    for (Memory& memory : process.memories) {
      if (is_far(target, memory)) memory.load_latency = kFarRead;
      memory.is_block_table = is_block_table(target, memory);
    }
    add_memory_ports(process);
    CompiledProcess made{process, schedule_process(process, schedule_options_, result_.diagnostics)};
    note_memory_ports(made);
    tell("schedule", made.process, &made.schedule);
    return made;
  }

  /// Gives a memory another port: a copy to read, or outside a memory with two ports.
  static bool add_memory_port(Process& process, const Block& loop, int memory) {
    if (memory < 0) return false;
    Memory& array = process.memories[memory];
    if (array.may_have_two_ports && !array.has_two_ports) return array.has_two_ports = true;
    if (loop.wanted_ii == 0 || !can_copy_memory(process, memory)) return false;
    copy_memory(process, memory);
    return true;
  }

  /// Gives memories another port where a loop comes nearer to the II asked for by that.
  void add_memory_ports(Process& process) const {
    Diagnostics ignored;
    ScheduleOptions options = schedule_options_;
    options.saves_registers = false;
    ProcessSchedule schedule = schedule_process(process, options, ignored);
    for (size_t block = 0; block < process.blocks.size(); ++block) {
      Process wider = process;
      ProcessSchedule after = schedule;
      while (add_memory_port(wider, process.blocks[block], after.blocks[block].limiting_memory))
        after = schedule_process(wider, options, ignored);
      if (after.blocks[block].ii >= schedule.blocks[block].ii) continue;
      process = std::move(wider);
      schedule = std::move(after);
    }
  }

  static void note_memory_ports(CompiledProcess& made) {
    for (const Block& block : made.process.blocks)
      for (ValueId id : block.operations) {
        const Operation& op = made.process[id];
        if (!op.is_memory_access() || made.process.memories[op.object].kind != MemoryKind::kPort) continue;
        std::vector<MemoryPort>& ports = made.process.memories[op.object].ports;
        size_t number = made.schedule.port[id];
        ports.resize(std::max(ports.size(), number + 1));
        (op.kind == OpKind::kLoad ? ports[number].reads : ports[number].writes) = true;
      }
  }

  void tell(const char* stage, const Process& process, const ProcessSchedule* schedule = nullptr) const {
    if (options_.on_stage) options_.on_stage(stage, process, schedule);
  }

  /// LATENCY of a process is a promise that the schedule keeps or not.
  void check_latency(const std::string& function, const CompiledProcess& compiled) {
    std::optional<Directive> wanted = function_directive(*program_.module->getFunction(function), "LATENCY");
    if (!wanted) return;
    Latency latency = LatencyModel(compiled.process, compiled.schedule).process();
    uint64_t least = wanted->integer("min", 0), most = wanted->integer("max", 0);
    bool is_known = latency.terms.empty() && !latency.is_endless;
    if (is_known && latency.cycles >= least && (most == 0 || latency.cycles <= most)) return;
    result_.diagnostics.warn(compiled.process.location,
                             "LATENCY of '" + compiled.process.source_name + "' does not hold: it takes " +
                                 (latency.is_bound ? "up to " : "") + latency.text() + " cycles");
  }

  void add_process(Process process, const std::string& function) {
    CompiledProcess compiled = scheduled(std::move(process));
    check_latency(function, compiled);
    result_.files.push_back({compiled.process.name + ".v",
                             emit_process(compiled.process, compiled.schedule, options_.has_probes)});
    result_.processes.push_back(std::move(compiled));
  }

  Region region_of(const MiddleResult& middle, const std::vector<Process>& processes) const {
    try {
      return build_region(program_, middle, processes);
    } catch (const CompileError& reason) {
      throw RegionError(reason);
    }
  }

  TopModule region_top(const MiddleResult& middle, PortModes modes) {
    std::vector<Process> processes;
    for (const CompiledProcess& compiled : result_.processes) processes.push_back(compiled.process);
    Region region = region_of(middle, processes);
    for (RegionStream& stream : region.streams)
      stream.depth = std::max<int>(stream.depth, schedule_options_.target.least_fifo);
    bool is_of_tasks = std::all_of(region.instances.begin(), region.instances.end(),
                                   [](const Instance& instance) { return instance.is_task; });
    if (is_of_tasks) {
      std::string control = modes.mode("return");
      if (!control.empty() && control != "ap_ctrl_none")
        throw CompileError(result_.top.location,
                           "tasks alone neither start nor end, so there is nothing for '" + control +
                               "' to tell; write ap_ctrl_none, or nothing, for port=return");
      modes.by_port["return"].options["mode"] = "ap_ctrl_none";
    }
    CompiledProcess head = scheduled(region.head);
    region.head = head.process;
    result_.files.push_back(
        {head.process.name + ".v", is_combinational(head.process)
                                       ? emit_combinational(head.process)
                                       : emit_process(head.process, head.schedule, /*has_probes=*/false)});
    std::vector<const Process*> pointers;
    for (const CompiledProcess& compiled : result_.processes) pointers.push_back(&compiled.process);
    return emit_dataflow_top(result_.top, region, pointers, modes, options_.taps, options_.has_probes);
  }

  const CompileOptions& options_;
  Places apart_, flattened_;
  bool in_sequence_;
  CompileResult result_;
  Program program_;
  ScheduleOptions schedule_options_;
  NameTable names_;
};

bool needs_processes(const CompileOptions& options) {
  Program program = parse_program(options.frontend);
  return declares_streams_or_tasks(*program.module);
}

/// Nests are flattened where that costs no II: those that miss theirs are tried apart.
CompileResult compile_best(const CompileOptions& options, bool in_sequence) {
  Compilation flat(options, {}, in_sequence);
  flat.run();
  const Places slow = flat.slow_nests();
  if (slow.empty()) return std::move(flat.result());
  Compilation separate(options, slow, in_sequence);
  separate.run();
  Places apart;
  for (const std::string& place : slow)
    if (separate.interval(place) < flat.interval(place)) apart.insert(place);
  if (apart.empty()) return std::move(flat.result());
  if (apart == slow) return std::move(separate.result());
  Compilation mixed(options, apart, in_sequence);
  mixed.run();
  return std::move(mixed.result());
}

/// A DATAFLOW function whose calls cannot be processes runs them one after the other, as C++ does, with a
/// warning that says why; unless streams lie between them, whose depth that would take nobody knows, or they
/// are tasks, which do not end.
CompileResult compile_any(const CompileOptions& options) {
  try {
    return compile_best(options, /*in_sequence=*/false);
  } catch (const RegionError& reason) {
    if (reason.where().line == 0 || needs_processes(options)) throw;
    CompileResult result = compile_best(options, /*in_sequence=*/true);
    Diagnostics all;
    all.warn(reason.where(),
             "DATAFLOW has no effect, the calls run one after the other: " + reason.sentence());
    std::ranges::copy(result.diagnostics.warnings, std::back_inserter(all.warnings));
    result.diagnostics = all;
    return result;
  }
}

}  // namespace

ScheduleOptions schedule_options(const CompileOptions& options) {
  ScheduleOptions made;
  made.target = target_named(options.target);
  made.period = options.period;
  return made;
}

CompileResult compile(const CompileOptions& options) {
  CompileResult result = compile_any(options);
  const std::vector<std::string>& warnings = result.diagnostics.warnings;
  if (options.strict && !warnings.empty()) throw StrictWarning(warnings[0]);
  return result;
}

}  // namespace hlsc
