#include "cosim/cosim.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "cosim/adapter.h"
#include "cosim/program_build.h"

namespace hlsc {
namespace {

namespace fs = std::filesystem;

class Simulation {
 public:
  Simulation(const CompileResult& compiled, const CompileOptions& options, const CosimOptions& cosim)
      : compiled_(compiled), options_(options), cosim_(cosim), work_(cosim.work_dir), dir_(work_.path()) {}

  int run() {
    write_files();
    build("model");
    fs::remove(note());
    int code = simulate("HLSC_STANDS_STILL=" + shell_word(note().string()), "");
    if (word_in(note()) == "full") advise_depths();
    return code;
  }

 private:
  void write(const std::string& name, const std::string& text) { std::ofstream(dir_ / name) << text; }

  void write_files() {
    for (const GeneratedFile& file : compiled_.files) write(file.name, file.text);
    write("adapter.cpp", adapter_text(compiled_, options_, model()));
  }

  std::string model() const { return "V" + compiled_.interface.module; }

  /// Written by a simulation that stands still.
  fs::path note() const { return dir_ / "stands_still"; }

  static std::string word_in(const fs::path& path) {
    std::string word;
    std::ifstream(path) >> word;
    return word;
  }

  void build(const std::string& model_dir, const std::string& library = "") {
    model_dir_ = dir_ / model_dir;
    build_model(library);
    build_program();
  }

  /// Runs the test bench; `environment` as NAME=VALUE words, `output` as a redirection.
  int simulate(const std::string& environment, const std::string& output) const {
    std::string command = "cd " + shell_word(cosim_.run_dir) +
                          " && HLSC_STALL=" + std::to_string(cosim_.stall) + " " + environment + " " +
                          shell_word((dir_ / "simulation").string()) + output;
    return exit_code(std::system(command.c_str()));
  }

  /// Runs once more, with FIFOs that grow when nothing moves, and tells the depths with which it ends.
  void advise_depths() {
    build("growing", " -y " + shell_word(HLSC_COSIM_DIR "/growing"));
    fs::path depths = dir_ / "depths";
    fs::remove(depths);
    simulate("HLSC_DEPTHS=" + shell_word(depths.string()),
             " > " + shell_word((dir_ / "growing.log").string()) + " 2>&1");
    if (!fs::exists(depths)) {
      std::cerr << "  deeper FIFOs do not help\n";
      return;
    }
    std::ifstream in(depths);
    std::string stream;
    for (int declared = 0, enough = 0; in >> stream >> declared >> enough;)
      std::cerr << "  stream '" << stream << "': depth " << enough << " would do, it is " << declared << "\n";
  }

  void build_model(const std::string& library) {
    std::string command = "verilator --cc --Mdir " + shell_word(model_dir_.string()) + " --top-module " +
                          compiled_.interface.module +
                          " -O3 --x-assign unique --x-initial unique -Wno-fatal" + library + " -y " +
                          shell_word(HLSC_RTL_LIB_DIR);
    if (!cosim_.trace.empty()) command += " --trace";
    for (const GeneratedFile& file : compiled_.files)
      if (fs::path(file.name).extension() == ".v") command += " " + shell_word((dir_ / file.name).string());
    run_or_throw(command, dir_ / "verilator.log", "Verilator refuses the generated Verilog");
  }

  void build_program() {
    ProgramBuild program(dir_);
    std::string root = verilator_root();
    std::string define_trace = cosim_.trace.empty() ? " -DVM_TRACE=0" : " -DVM_TRACE=1 -DVM_TRACE_VCD=1";
    // The same words for every design, so that ccache knows the runtime.
    std::string runtime_flags = " -std=c++17 -O1 -w" + define_trace + " -I" + shell_word(root + "/include") +
                                " -I" + shell_word(root + "/include/vltstd");
    std::string flags =
        runtime_flags + " -I" + shell_word(model_dir_.string()) + " -I" HLSC_COSIM_DIR " -I" HLSC_TYPES_DIR;
    for (const std::string& include : options_.frontend.include_dirs) flags += " -I" + shell_word(include);
    for (const std::string& define : options_.frontend.defines) flags += " -D" + shell_word(define);
    flags += cosim_.trace.empty() ? " -DHLSC_TRACE=0"
                                  : " -DHLSC_TRACE=1 -DHLSC_TRACE_FILE=" +
                                        shell_word("\"" + fs::absolute(cosim_.trace).string() + "\"");
    for (const char* name : {"verilated.cpp", "verilated_threads.cpp"})
      program.add(root + "/include/" + name, runtime_flags);
    if (!cosim_.trace.empty()) program.add(root + "/include/verilated_vcd_c.cpp", runtime_flags);
    std::string bench_flags = flags;
    for (const std::string& flag : cosim_.flags) bench_flags += " " + shell_word(flag);
    for (const std::string& bench : cosim_.test_benches) program.add(bench, bench_flags);
    program.add((dir_ / "adapter.cpp").string(), flags);
    for (const auto& entry : fs::directory_iterator(model_dir_))
      if (entry.path().extension() == ".cpp") program.add(entry.path().string(), flags);
    program.link();
  }

  static std::string verilator_root() {
    FILE* pipe = popen("verilator --getenv VERILATOR_ROOT", "r");
    if (!pipe) throw CompileError("cannot run verilator; install it");
    std::string root;
    for (int c = fgetc(pipe); c != EOF && c != '\n'; c = fgetc(pipe)) root += static_cast<char>(c);
    pclose(pipe);
    if (root.empty()) throw CompileError("cannot run verilator; install it");
    return root;
  }

  const CompileResult& compiled_;
  const CompileOptions& options_;
  const CosimOptions& cosim_;
  WorkDirectory work_;
  fs::path dir_, model_dir_;
};

}  // namespace

int cosimulate(const CompileResult& compiled, const CompileOptions& options, const CosimOptions& cosim) {
  return Simulation(compiled, options, cosim).run();
}

}  // namespace hlsc
