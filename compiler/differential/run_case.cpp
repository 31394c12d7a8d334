#include "differential/run_case.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "differential/child.h"
#include "differential/expectation.h"
#include "differential/native_program.h"
#include "differential/stage_check.h"
#include "differential/steering.h"
#include "differential/verilog_bench.h"
#include "tool/compile.h"

namespace hlsc::differential {
namespace {

namespace fs = std::filesystem;

constexpr int kCompileSeconds = 60, kNativeSeconds = 60, kSimulationSeconds = 120;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The steps in the child process. Each returns pass or ends the case.
class CaseRun {
 public:
  CaseRun(const fs::path& kernel, const fs::path& work, std::uint64_t seed)
      : kernel_(kernel), work_(work), seed_(seed) {}

  CaseResult run() {
    try {
      compile_kernel();
      std::string broken = failed_expectation(report_of(compiled_, schedule_options(options_)), steering_);
      if (!broken.empty()) return {Outcome::kExpectation, broken};
      CaseResult native = run_native();
      if (native.outcome != Outcome::kPass) return native;
      std::string wrong = stages_.wrong_stage(compiled_, steering_, work_);
      if (!wrong.empty()) return {Outcome::kMismatch, wrong};
      return run_verilog();
    } catch (const CompileError& refusal) {
      return {Outcome::kRefused, first_line(refusal.what())};
    } catch (const std::exception& failure) {
      return {Outcome::kNative, first_line(failure.what())};
    }
  }

 private:
  void compile_kernel() {
    steering_ = read_steering(kernel_);
    if (steering_.top.empty())
      throw std::runtime_error("the case does not name its top; write `// top: NAME` in its head.");
    options_.frontend.top = steering_.top;
    options_.frontend.files = {kernel_.string()};
    for (const std::string& file : steering_.files)
      options_.frontend.files.push_back((kernel_.parent_path() / file).string());
    options_.on_stage = stages_.observer();
    compiled_ = compile(options_);
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(work_ / name) << text; }
  std::string in_work(const std::string& command) const {
    return fmt::format("cd '{}' && {}", work_.string(), command);
  }
  std::string log(const std::string& name) const { return (work_ / name).string(); }
  CaseResult failed_step(Outcome outcome, const ChildResult& step, const std::string& what,
                         const std::string& log_name) const {
    if (step.kind == ChildResult::kTimeout) return {outcome, what + " does not end"};
    return {outcome, what + ": " + first_line(read_text(work_ / log_name))};
  }

  CaseResult run_native() {
    write("native.cpp", native_program(compiled_, options_, steering_, seed_));
    ChildResult built = run_command(in_work(DIFFERENTIAL_NATIVE_COMPILER " native.cpp -o native"),
                                    log("native_build.log"), kNativeSeconds);
    if (built.kind != ChildResult::kExit || built.code != 0)
      return failed_step(Outcome::kNative, built, "native build", "native_build.log");
    ChildResult ran = run_command(in_work("./native"), log("native.log"), kNativeSeconds);
    if (ran.kind != ChildResult::kExit || ran.code != 0)
      return failed_step(Outcome::kNative, ran, "native run", "native.log");
    return {};
  }

  CaseResult run_verilog() {
    RecordedSizes sizes;
    for (std::size_t i = 0; i < compiled_.interface.streams.size(); ++i) {
      std::ifstream words(work_ / fmt::format("stream_{}_hex", i));
      sizes.streams.push_back(std::count(std::istreambuf_iterator<char>(words), {}, '\n'));
    }
    std::string sources = "bench.v";
    for (const GeneratedFile& file : compiled_.files) {
      write(file.name, file.text);
      sources += " " + file.name;
    }
    write("bench.v", verilog_bench(compiled_, steering_, sizes, seed_));
    ChildResult built =
        run_command(in_work("iverilog -g2005 -s bench -y " DIFFERENTIAL_RTL_LIB " -o bench.vvp " + sources),
                    log("iverilog.log"), kSimulationSeconds);
    if (built.kind != ChildResult::kExit || built.code != 0)
      return failed_step(Outcome::kVerilog, built, "Icarus", "iverilog.log");
    ChildResult ran = run_command(in_work("vvp -n bench.vvp"), log("simulation.log"), kSimulationSeconds);
    if (ran.kind == ChildResult::kTimeout) return {Outcome::kDeadlock, "the simulation does not end"};
    std::string text = read_text(work_ / "simulation.log");
    if (text.rfind("PASS", 0) == 0) {
      std::string wrong = wrong_latency(first_line(text));
      return {wrong.empty() ? Outcome::kPass : Outcome::kExpectation, wrong};
    }
    return {text.find("nothing moves") == std::string::npos ? Outcome::kMismatch : Outcome::kDeadlock,
            first_line(text)};
  }

  /// The report's latency against the longest run, where nothing outside can make the process wait.
  std::string wrong_latency(const std::string& verdict) const {
    const TopInterface& ports = compiled_.interface;
    Report report = report_of(compiled_, schedule_options(options_));
    bool is_region =
        compiled_.processes.size() != 1 || compiled_.processes[0].process.source_name != compiled_.top.name;
    bool overlaps = !is_region && compiled_.processes[0].process.call_loop() >= 0 && seed_ % 2 == 1;
    if (overlaps || !ports.has_start || ports.has_continue || !ports.streams.empty() || is_region) return "";
    const Latency& told = report.modules[0].latency;
    if (!told.terms.empty() || told.is_endless) return "";
    uint64_t longest = std::stoull(verdict.substr(verdict.find_last_of(' ')));
    if (told.is_bound ? longest <= told.cycles : longest == told.cycles) return "";
    return fmt::format("the report says {}{} cycles, a run takes {}", told.is_bound ? "up to " : "",
                       told.cycles, longest);
  }

  fs::path kernel_, work_;
  std::uint64_t seed_;
  Steering steering_;
  CompileOptions options_;
  CompileResult compiled_;
  StageCheck stages_;
};

}  // namespace

const char* name_of(Outcome outcome) {
  static const char* const kNames[] = {"pass",    "refused", "mismatch", "deadlock", "expectation",
                                       "verilog", "native",  "crash",    "hang"};
  return kNames[static_cast<int>(outcome)];
}

CaseResult run_case(const fs::path& kernel, const fs::path& work, std::uint64_t seed) {
  const fs::path verdict = work / "verdict";
  fs::remove(verdict);
  ChildResult child = run_child(
      [&] {
        CaseResult result = CaseRun(fs::absolute(kernel), fs::absolute(work), seed).run();
        std::ofstream(verdict) << result.detail;
        return static_cast<int>(result.outcome);
      },
      kCompileSeconds + 2 * kNativeSeconds + 2 * kSimulationSeconds);
  if (child.kind == ChildResult::kTimeout) return {Outcome::kHang, "the compiler does not end"};
  if (child.kind == ChildResult::kSignal || !fs::exists(verdict))
    return {Outcome::kCrash, fmt::format("signal {}", child.code)};
  return {static_cast<Outcome>(child.code), read_text(verdict)};
}

}  // namespace hlsc::differential
