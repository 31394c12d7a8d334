/// The subcommands. Each file NAME_command.cpp adds one to the command line and runs it.
#ifndef FLOORLINE_APPS_COMMAND_H
#define FLOORLINE_APPS_COMMAND_H

#include <CLI/App.hpp>
#include <functional>

#include "exit_code.h"

namespace floorline::app {

/// A subcommand and what it does once the command line is parsed.
struct Command {
  CLI::App* parser;
  std::function<ExitCode()> run;
};

Command add_import(CLI::App& app);
Command add_render(CLI::App& app);
Command add_mount(CLI::App& app);
Command add_golden(CLI::App& app);
Command add_csim(CLI::App& app);
Command add_check(CLI::App& app);
Command add_score(CLI::App& app);
Command add_report(CLI::App& app);
Command add_cosim(CLI::App& app);
Command add_cycles(CLI::App& app);

}  // namespace floorline::app

#endif
