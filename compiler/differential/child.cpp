#include "differential/child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>

namespace hlsc::differential {
namespace {

constexpr int kPatience = 20;  ///< Seconds of waiting for a second of work: the machine has others to serve.

ChildResult outcome_of(int status) {
  if (WIFSIGNALED(status))
    return {WTERMSIG(status) == SIGXCPU ? ChildResult::kTimeout : ChildResult::kSignal, WTERMSIG(status)};
  bool is_late = WEXITSTATUS(status) == 128 + SIGXCPU;  // As a shell tells it.
  return {is_late ? ChildResult::kTimeout : ChildResult::kExit, WEXITSTATUS(status)};
}

ChildResult wait_for(pid_t child, int seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds) * kPatience;
  for (int status = 0;;) {
    if (waitpid(child, &status, WNOHANG) == child) return outcome_of(status);
    if (std::chrono::steady_clock::now() > end) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      return {ChildResult::kTimeout, 0};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace

ChildResult run_child(const std::function<int()>& work, int seconds) {
  std::fflush(nullptr);
  pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process; end some others.");
  if (child == 0) {
    setpgid(0, 0);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    rlimit time{};
    getrlimit(RLIMIT_CPU, &time);
    time.rlim_cur = seconds;
    setrlimit(RLIMIT_CPU, &time);
    int code = work();
    std::fflush(nullptr);
    _exit(code);
  }
  setpgid(child, child);
  return wait_for(child, seconds);
}

ChildResult run_command(const std::string& command, const std::string& log, int seconds) {
  return run_child(
      [&] {
        int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
        dup2(file, 1);
        dup2(file, 2);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        return 127;
      },
      seconds);
}

}  // namespace hlsc::differential
