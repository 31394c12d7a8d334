/// floorline check: golden against C simulation, stage by stage, with a verdict.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "check.h"
#include "command.h"
#include "figure_table.h"
#include "output.h"

namespace floorline::app {
namespace {

struct Options {
  std::string sequence;
  DriveOptions drive;
  Output results;
};

constexpr const char* footer =
    "Examples:\n"
    "  floorline check out/room\n"
    "  floorline check out/kitti06 --poses exact --json out/check.json\n"
    "Every kernel is compared with its golden twin on the same input; the last line compares the contact "
    "points of both whole\n"
    "pipelines. Exit code 1 when a bound is missed.";

ExitCode run(const Options& options) {
  Drive drive(options.sequence, options.drive.settings(), options.drive.poses());
  const CheckResult result = check(drive, [](const CheckedFrame&) {});
  options.results.text(fmt::format("{}: {} frames, {} contact points of both models\n\n{}", options.sequence,
                                   drive.frame_count(), result.contacts, figure_table(result.figures)));
  options.results.json({{"sequence", options.sequence},
                        {"frames", drive.frame_count()},
                        {"contacts", result.contacts},
                        {"figures", to_json(result.figures)},
                        {"verdict", result.ok() ? "ok" : "short"}});
  return result.ok() ? ExitCode::ok : ExitCode::short_of_bound;
}

}  // namespace

Command add_check(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("check", "Compare golden model and C simulation, stage by stage");
  parser->footer(footer);
  parser->add_option("SEQUENCE", options->sequence, "Sequence folder")->required();
  options->drive.add_to(*parser);
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
