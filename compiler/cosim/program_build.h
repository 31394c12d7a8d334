/// Compiling and linking the native programs that simulate.
#ifndef HLSC_COSIM_PROGRAM_BUILD_H
#define HLSC_COSIM_PROGRAM_BUILD_H

#include <filesystem>
#include <string>

namespace hlsc {

/// A directory that goes away unless the user named it.
class WorkDirectory {
 public:
  explicit WorkDirectory(const std::string& wanted);
  ~WorkDirectory();
  const std::filesystem::path& path() const { return path_; }

 private:
  bool is_temporary_;
  std::filesystem::path path_;
};

std::string shell_word(const std::string& text);

/// Of a status that std::system gave.
int exit_code(int status);

/// Throws CompileError with what the command said when it fails; `what` is the sentence before.
void run_or_throw(const std::string& command, const std::filesystem::path& log, const std::string& what);

/// A program from C++, C and LLVM IR, built in a directory as `simulation`.
class ProgramBuild {
 public:
  explicit ProgramBuild(std::filesystem::path directory) : dir_(std::move(directory)) {}

  /// Compiles one source.
  void add(const std::string& source, const std::string& flags);
  /// Of definitions that are there twice the first is taken: a test bench may hold the same helper functions
  /// as the design.
  void link() const;

 private:
  std::filesystem::path dir_;
  std::string objects_;
};

}  // namespace hlsc

#endif
