#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "interrupt.h"

namespace floorline::app {
namespace {

using namespace std::chrono_literals;

std::string duration_text(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  return whole < 60 ? fmt::format("{} s", whole) : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(std::string task)
    : task_(std::move(task)),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_shown_(start_) {}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

std::string Progress::line(int done, int total) const {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = std::max(done, 1) / std::max(elapsed, 1e-3);
  if (total == 0) return fmt::format("{}: {} frames, {:.3g} a second", task_, done, rate);
  return fmt::format("{}: {} of {} frames, {:.3g} a second, {} left", task_, done, total, rate,
                     duration_text((total - done) / rate));
}

void Progress::advance(int done, int total) {
  throw_if_interrupted();
  const auto now = Clock::now();
  if (now - last_shown_ < (terminal_ ? Clock::duration(100ms) : Clock::duration(10s))) return;
  last_shown_ = now;
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", line(done, total));
  else
    fmt::print(stderr, "{}\n", line(done, total));
  std::fflush(stderr);
}

}  // namespace floorline::app
