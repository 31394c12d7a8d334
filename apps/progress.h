/// Progress of long work on stderr: one line with rate and remaining time on a terminal, a line every ten
/// seconds elsewhere.
#ifndef FLOORLINE_APPS_PROGRESS_H
#define FLOORLINE_APPS_PROGRESS_H

#include <chrono>
#include <string>

namespace floorline::app {

class Progress {
 public:
  /// `task` names the work.
  explicit Progress(std::string task);
  /// Clears the terminal's line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Tells that `done` frames of `total` (0: not known) are done. Throws Interrupted after Ctrl-C.
  void advance(int done, int total);

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(int done, int total) const;

  const std::string task_;
  const bool terminal_;
  const Clock::time_point start_;
  Clock::time_point last_shown_;
};

}  // namespace floorline::app

#endif
