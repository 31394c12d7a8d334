/// floorline-hlsc: HLS C++ to Verilog.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "cosim/cosim.h"
#include "report/write.h"
#include "tool/compile.h"

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

void add_compile_options(CLI::App& command, hlsc::CompileOptions& options) {
  command.add_option("files", options.frontend.files, "C++ or C sources of the design")
      ->required()
      ->check(CLI::ExistingFile);
  command.add_option("--top", options.frontend.top, "name of the top function")->required();
  command.add_option("-I", options.frontend.include_dirs, "include directory");
  command.add_option("-D", options.frontend.defines, "macro definition");
  command.add_option("--std", options.frontend.standard, "language standard, as c++11");
  command.add_option("--target", options.target, "xc6v, xc7 or ecp5")->capture_default_str();
  command.add_option("--clock", options.period, "clock period in ns")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_flag("--strict", options.strict, "make the first warning an error");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("High-level synthesis: Vitis-style C++ to Verilog");
  app.require_subcommand(1);
  hlsc::CompileOptions options;
  std::string output_dir = ".";
  CLI::App* compile = app.add_subcommand("compile", "compile a top function to Verilog");
  add_compile_options(*compile, options);
  compile->add_option("-o,--output", output_dir, "directory for the Verilog files")->capture_default_str();
  std::string report_dir;
  compile->add_option("--report", report_dir,
                      "directory for report.txt, .json and .html; default: that of the Verilog files");
  CLI::App* cosim = app.add_subcommand("cosim", "run a test bench against the compiled Verilog");
  add_compile_options(*cosim, options);
  hlsc::CosimOptions cosim_options;
  cosim->add_option("--tb", cosim_options.test_bench, "test bench with main(), C++ or C")
      ->required()
      ->check(CLI::ExistingFile);
  cosim->add_option("--stall", cosim_options.stall, "seed of random stalls on all streams; 0: none");
  cosim->add_option("--trace", cosim_options.trace, "write waves to this VCD file");
  cosim->add_option("--work", cosim_options.work_dir, "keep the generated files in this directory");
  CLI11_PARSE(app, argc, argv);
  try {
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
