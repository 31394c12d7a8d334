#include "cosim/program_build.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "frontend/diagnostic.h"

namespace hlsc {

namespace fs = std::filesystem;

WorkDirectory::WorkDirectory(const std::string& wanted) : is_temporary_(wanted.empty()) {
  if (is_temporary_) {
    std::string pattern = (fs::temp_directory_path() / "hlsc-cosim-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw CompileError("cannot make a temporary directory; set TMPDIR or give --work");
    path_ = pattern;
  } else {
    fs::create_directories(wanted);
    path_ = fs::absolute(wanted);
  }
}

WorkDirectory::~WorkDirectory() {
  std::error_code ignored;
  if (is_temporary_) fs::remove_all(path_, ignored);
}

std::string shell_word(const std::string& text) {
  std::string out = "'";
  for (char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

int exit_code(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128; }

namespace {

/// What the command says when it fails; empty when it does not.
std::string failure_of(const std::string& command, const fs::path& log) {
  if (exit_code(std::system((command + " > " + shell_word(log.string()) + " 2>&1").c_str())) == 0) return "";
  std::ifstream in(log);
  std::stringstream text;
  text << in.rdbuf();
  return text.str().empty() ? "it failed without a word" : text.str();
}

/// The C++ compiler, behind ccache where there is one: the Verilator runtime is the same for every design.
std::string cxx() {
  bool has_ccache = std::system("command -v ccache > /dev/null 2>&1") == 0;
  return std::string(has_ccache ? "ccache " : "") + HLSC_CLANG;
}

}  // namespace

void run_or_throw(const std::string& command, const fs::path& log, const std::string& what) {
  std::string failure = failure_of(command, log);
  if (!failure.empty()) throw CompileError(what + ":\n" + failure);
}

void ProgramBuild::add(const std::string& source, const std::string& flags) {
  std::string object = shell_word((dir_ / (fs::path(source).stem().string() + ".o")).string());
  std::string language = fs::path(source).extension() == ".c" ? " -x c -std=c17" : "";
  run_or_throw(cxx() + flags + language + " -c " + shell_word(source) + " -o " + object, dir_ / "compile.log",
               "cannot compile " + source);
  objects_ += " " + object;
}

void ProgramBuild::link() const {
  std::string command = std::string(HLSC_CLANG) + " -fuse-ld=lld -Wl,-z,muldefs" + objects_ +
                        " -pthread -o " + shell_word((dir_ / "simulation").string());
  std::string failure = failure_of(command, dir_ / "link.log");
  if (failure.find("undefined symbol: main") != std::string::npos)
    throw CompileError("no test bench has a main(); name the file that has it with --tb or tb.file");
  if (!failure.empty()) throw CompileError("cannot link the simulation:\n" + failure);
}

}  // namespace hlsc
