/// The `floorline` command: from images and odometry to obstacles on the floor, and everything that checks
/// it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "command.h"
#include "interrupt.h"

namespace {

using floorline::app::Command;
using floorline::app::ExitCode;

constexpr const char* description =
    "Obstacles on the floor from one calibrated camera and wheel odometry: the fixed-point FPGA pipeline in "
    "C simulation,\n"
    "its floating-point twin, and the commands that feed, compare and score them.";

constexpr const char* footer =
    "Example: from nothing to a report\n"
    "  floorline render --seed 7 --output out/room\n"
    "  floorline check out/room\n"
    "  floorline report out/room --output out/room.html\n\n"
    "Exit codes: 0 ok, 1 a figure misses its bound, 2 bad usage, 3 bad input, 4 internal fault, 130 "
    "interrupted.";

int code(ExitCode exit_code) { return static_cast<int>(exit_code); }

/// One line on stderr, whatever the library put into its message.
int fail(ExitCode exit_code, std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  fmt::print(stderr, "error: {}\n", message);
  return code(exit_code);
}

int run(CLI::App& app, const std::vector<Command>& commands, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    for (const Command& command : commands) {
      if (*command.parser) return code(command.run());
    }
    return code(ExitCode::ok);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    const std::string name =
        app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name();
    return fail(ExitCode::bad_usage, fmt::format("{} ('floorline{} --help' shows how.)", error.what(), name));
  } catch (const floorline::app::Interrupted&) {
    return fail(ExitCode::interrupted, "interrupted; nothing half-written was left.");
  } catch (const std::runtime_error& error) {
    return fail(ExitCode::bad_input, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::bad_input, "out of memory; use smaller images or fewer frames.");
  } catch (const std::exception& error) {
    return fail(ExitCode::internal, fmt::format("internal fault, please report it: {}", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace floorline::app;
  CLI::App app(description, "floorline");
  app.footer(footer);
  app.set_version_flag("--version", FLOORLINE_VERSION);
  app.require_subcommand(1);
  const std::vector<Command> commands = {add_import(app), add_render(app), add_mount(app), add_golden(app),
                                         add_csim(app),   add_check(app),  add_score(app), add_report(app),
                                         add_cosim(app),  add_cycles(app)};
  catch_interrupts();
  return run(app, commands, argc, argv);
}
