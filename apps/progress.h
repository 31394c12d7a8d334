/// Progress of long work on stderr: one line with rate and remaining time on a terminal, a line every ten
/// seconds elsewhere.
#ifndef FLOORLINE_APPS_PROGRESS_H
#define FLOORLINE_APPS_PROGRESS_H

#include <chrono>
#include <string>

namespace floorline::app {

class Progress {
 public:
  /// `task` names the work, `unit` what is counted, in the plural ("frames").
  Progress(std::string task, int total, std::string unit = "frames");
  /// Clears the terminal's line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Tells that `done` of all are done. Throws Interrupted after Ctrl-C.
  void advance(int done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(int done) const;

  const std::string task_;
  const int total_;
  const std::string unit_;
  const bool terminal_;
  const Clock::time_point start_;
  Clock::time_point last_shown_;
};

}  // namespace floorline::app

#endif
