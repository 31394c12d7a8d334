/// Exit codes of the floorline command, for scripts; docs/command.md repeats them.
#ifndef FLOORLINE_APPS_EXIT_CODE_H
#define FLOORLINE_APPS_EXIT_CODE_H

namespace floorline::app {

enum class ExitCode : int {
  ok = 0,
  short_of_bound = 1,  ///< check or score ran, and a figure misses its bound.
  bad_usage = 2,       ///< The command line.
  bad_input = 3,       ///< A file, or something that could not be written.
  internal = 4,        ///< A fault of the program.
  interrupted = 130,   ///< Ctrl-C; nothing half-written is left.
};

}  // namespace floorline::app

#endif
