/// floorline-hlsc: HLS C++ to Verilog.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "cosim/cosim.h"
#include "cosim/csim.h"
#include "report/write.h"
#include "tool/compile.h"
#include "tool/project_file.h"

namespace {

void write_whole(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::path part = path.string() + ".part";
  {
    std::ofstream out(part);
    out << text;
    if (!out.flush())
      throw std::runtime_error("error: cannot write " + path.string() + "; check the directory");
  }
  std::filesystem::rename(part, path);
}

void write_files(const hlsc::CompileResult& result, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  for (const hlsc::GeneratedFile& file : result.files) write_whole(directory / file.name, file.text);
}

void write_report(const hlsc::Report& report, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  write_whole(directory / "report.txt", hlsc::report_text(report));
  write_whole(directory / "report.json", hlsc::report_json(report));
  write_whole(directory / "report.html", hlsc::report_page(report));
}

/// Project files given on the command line.
struct Project {
  std::string config, tcl;
};

/// What the command line leaves open comes from the project.
void apply(const Project& project, hlsc::CompileOptions& options, hlsc::CosimOptions& cosim) {
  hlsc::FrontendOptions& frontend = options.frontend;
  if (!project.config.empty()) {
    hlsc::ProjectFile file = hlsc::read_config(project.config);
    if (frontend.files.empty()) frontend.files = file.files;
    if (frontend.top.empty()) frontend.top = file.top;
    if (frontend.standard.empty()) frontend.standard = file.standard;
    if (options.target.empty()) options.target = file.target;
    if (options.period == 0) options.period = file.period;
    frontend.include_dirs.insert(frontend.include_dirs.end(), file.include_dirs.begin(),
                                 file.include_dirs.end());
    frontend.defines.insert(frontend.defines.end(), file.defines.begin(), file.defines.end());
    frontend.directives = file.directives;
    for (const std::string& bench : file.test_bench_files)
      if (hlsc::is_source_file(bench)) cosim.test_benches.push_back(bench);
    cosim.flags = file.test_bench_flags;
    cosim.run_dir = std::filesystem::absolute(project.config).parent_path();
  }
  if (!project.tcl.empty())
    for (const hlsc::PlacedDirective& directive : hlsc::read_tcl_directives(project.tcl))
      frontend.directives.push_back(directive);
  if (options.target.empty()) options.target = "xc7";
  if (options.period == 0) options.period = 10;
  if (frontend.files.empty())
    throw hlsc::CompileError("there are no sources; name them, or give --config with syn.file");
  if (frontend.top.empty()) throw hlsc::CompileError("there is no top; give --top, or --config with syn.top");
}

void add_compile_options(CLI::App& command, hlsc::CompileOptions& options, Project& project) {
  command.add_option("files", options.frontend.files, "C++ or C sources of the design")
      ->check(CLI::ExistingFile);
  command.add_option("--top", options.frontend.top, "name of the top function");
  command.add_option("--config", project.config, "a Vitis project: hls_config.cfg")->check(CLI::ExistingFile);
  command.add_option("--directives", project.tcl, "Tcl file with set_directive_* commands")
      ->check(CLI::ExistingFile);
  command.add_option("-I", options.frontend.include_dirs, "include directory");
  command.add_option("-D", options.frontend.defines, "macro definition");
  command.add_option("--std", options.frontend.standard, "language standard, as c++11");
  command.add_option("--target", options.target, "xc6v, xc7 (default) or ecp5");
  command.add_option("--clock", options.period, "clock period in ns, default 10")->check(CLI::PositiveNumber);
  command.add_flag("--strict", options.strict, "make the first warning an error");
}

void add_test_bench(CLI::App& command, hlsc::CosimOptions& options) {
  command.add_option("--tb", options.test_benches, "test bench, C++ or C, one file with main()")
      ->check(CLI::ExistingFile);
  command.add_option("--work", options.work_dir, "keep the generated files in this directory");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("High-level synthesis: Vitis-style C++ to Verilog");
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& failure) {
    return std::string("error: ") + failure.what() + "; floorline-hlsc --help tells the options\n";
  });
  hlsc::CompileOptions options;
  options.target.clear();
  options.period = 0;
  Project project;
  std::string output_dir = ".";
  CLI::App* compile = app.add_subcommand("compile", "compile a top function to Verilog");
  add_compile_options(*compile, options, project);
  compile->add_option("-o,--output", output_dir, "directory for the Verilog files")->capture_default_str();
  compile->add_option("--tap", options.taps,
                      "a stream between the processes that gets outputs to look at it");
  std::string report_dir;
  compile->add_option("--report", report_dir,
                      "directory for report.txt, .json and .html; default: that of the Verilog files");
  hlsc::CosimOptions cosim_options;
  CLI::App* csim = app.add_subcommand("csim", "run a test bench against the sources");
  add_compile_options(*csim, options, project);
  add_test_bench(*csim, cosim_options);
  bool finite_fifos = false;
  csim->add_flag("--finite-fifos", finite_fifos, "streams hold as many elements as declared");
  CLI::App* cosim = app.add_subcommand("cosim", "run a test bench against the compiled Verilog");
  add_compile_options(*cosim, options, project);
  add_test_bench(*cosim, cosim_options);
  cosim->add_option("--stall", cosim_options.stall, "seed of random stalls on all streams; 0: none");
  cosim->add_option("--trace", cosim_options.trace, "write waves to this VCD file");
  CLI11_PARSE(app, argc, argv);
  try {
    apply(project, options, cosim_options);
    if (!*compile && cosim_options.test_benches.empty())
      throw hlsc::CompileError("there is no test bench; give --tb, or --config with tb.file");
    if (*csim) return hlsc::simulate_in_c(options, cosim_options, finite_fifos);
    options.has_probes = cosim->parsed();
    hlsc::CompileResult result = hlsc::compile(options);
    for (const std::string& warning : result.diagnostics.warnings) std::cerr << warning << "\n";
    if (*cosim) return hlsc::cosimulate(result, options, cosim_options);
    write_files(result, output_dir);
    write_report(hlsc::report_of(result, hlsc::schedule_options(options)),
                 report_dir.empty() ? output_dir : report_dir);
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
  }
  return 0;
}
