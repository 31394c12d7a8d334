#include "cosim/csim.h"

#include <cstdlib>
#include <fstream>

#include "cosim/finite_fifos.h"
#include "cosim/program_build.h"

namespace hlsc {
namespace {

namespace fs = std::filesystem;

std::string native_flags(const CompileOptions& options, bool finite_fifos) {
  std::string flags = " -std=" + (options.frontend.standard.empty() ? "c++17" : options.frontend.standard) +
                      " -O1 -w -fwrapv";
  for (const std::string& include : options.frontend.include_dirs) flags += " -I" + shell_word(include);
  for (const std::string& define : options.frontend.defines) flags += " -D" + shell_word(define);
  return flags + (finite_fifos ? " -isystem " HLSC_COSIM_DIR "/finite" : "") + " -isystem " HLSC_TYPES_DIR;
}

/// The design as LLVM IR in a file of the directory.
std::string finite_design(const CompileOptions& options, const fs::path& directory) {
  FrontendOptions frontend = options.frontend;
  frontend.is_simulation = true;
  Program program = parse_program(frontend);
  fs::path file = directory / "hlsc_design.ll";
  std::ofstream(file) << finite_fifo_program(program);
  return file.string();
}

}  // namespace

int simulate_in_c(const CompileOptions& options, const CosimOptions& run, bool finite_fifos) {
  WorkDirectory work(run.work_dir);
  ProgramBuild program(work.path());
  std::string flags = native_flags(options, finite_fifos), bench_flags = flags;
  for (const std::string& flag : run.flags) bench_flags += " " + shell_word(flag);
  if (finite_fifos) {
    program.add(finite_design(options, work.path()), " -w -O1");
    program.add(HLSC_COSIM_DIR "/finite/processes.cpp", " -std=c++17 -O1 -w");
  } else {
    for (const std::string& source : options.frontend.files) program.add(source, flags);
  }
  for (const std::string& bench : run.test_benches) program.add(bench, bench_flags);
  program.link();
  return exit_code(std::system(
      ("cd " + shell_word(run.run_dir) + " && " + shell_word((work.path() / "simulation").string()))
          .c_str()));
}

}  // namespace hlsc
