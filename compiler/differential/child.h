/// Work in a process of its own, so that a crash or an endless loop is an outcome and not the end.
#pragma once

#include <functional>
#include <string>

namespace hlsc::differential {

struct ChildResult {
  enum Kind { kExit, kSignal, kTimeout } kind = kExit;
  int code = 0;  ///< Exit code or signal number.
};

/// Runs `work` in a forked process; its result is the exit code. The process is killed after `seconds`
/// of work (or when it sleeps for much longer).
ChildResult run_child(const std::function<int()>& work, int seconds);

/// Runs a shell command with standard output and error in `log`; killed after `seconds` of work.
ChildResult run_command(const std::string& command, const std::string& log, int seconds);

}  // namespace hlsc::differential
