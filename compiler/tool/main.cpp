/// floorline-hlsc: HLS C++ to Verilog.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>

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
  CLI11_PARSE(app, argc, argv);
  try {
    hlsc::CompileResult result = hlsc::compile(options);
    for (const std::string& warning : result.diagnostics.warnings) std::cerr << warning << "\n";
    std::filesystem::create_directories(output_dir);
    for (const hlsc::GeneratedFile& file : result.files)
      write_whole(std::filesystem::path(output_dir) / file.name, file.text);
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
  }
  return 0;
}
