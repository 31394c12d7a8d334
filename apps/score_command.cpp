/// floorline score: what a model finds against the ground truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "command.h"
#include "figure_table.h"
#include "output.h"
#include "score.h"

namespace floorline::app {
namespace {

struct Options {
  std::vector<std::string> sequences;
  std::string model = "csim";
  DriveOptions drive;
  Output results;
};

constexpr const char* footer =
    "Examples:\n"
    "  floorline score out/room\n"
    "  floorline score out/rooms/* --rule paper --json out/paper.json\n"
    "Several sequences are added up. Only frames whose baseline is mature count. Exit code 1 when a bound is "
    "missed; sequences\n"
    "whose truth is masks only (KITTI) have no bounds.";

DetectionScore score_all(const Options& options) {
  DetectionScore total;
  for (const std::string& folder : options.sequences) {
    Drive drive(folder, options.drive.settings(), options.drive.poses());
    const std::unique_ptr<Model> model =
        options.model == "golden" ? golden_model(drive) : csim_model(drive, true);
    total += score(drive, *model, "score " + folder);
  }
  return total;
}

nlohmann::json finite(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

ExitCode run(const Options& options) {
  const DetectionScore total = score_all(options);
  const std::vector<report::Figure> figures = score_figures(total);
  const bool ok =
      std::all_of(figures.begin(), figures.end(), [](const report::Figure& figure) { return figure.ok(); });
  options.results.text(
      fmt::format("{} sequences, {} frames with a mature baseline, {} due obstacles, {} reports\n",
                  options.sequences.size(), total.frames, total.per_frame.due,
                  total.per_frame.right + total.per_frame.wrong));
  if (!figures.empty()) options.results.text(figure_table(figures) + "\n");
  options.results.text(fmt::format(
      "  pixels: precision {:.3f}, recall {:.3f}\n  contact points at an obstacle of the mask: {:.3f}",
      total.pixels.precision(), total.pixels.recall(), total.mask.precision()));
  options.results.json({{"sequences", options.sequences},
                        {"frames", total.frames},
                        {"due", total.per_frame.due},
                        {"figures", to_json(figures)},
                        {"pixel_precision", finite(total.pixels.precision())},
                        {"pixel_recall", finite(total.pixels.recall())},
                        {"mask_precision", finite(total.mask.precision())},
                        {"verdict", ok ? "ok" : "short"}});
  return ok ? ExitCode::ok : ExitCode::short_of_bound;
}

}  // namespace

Command add_score(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("score", "Score a model against the ground truth");
  parser->footer(footer);
  parser->add_option("SEQUENCE", options->sequences, "Sequence folders")->required();
  parser->add_option("--model", options->model, "csim: the kernels; golden: the floating-point model")
      ->check(CLI::IsMember({"csim", "golden"}))
      ->capture_default_str();
  options->drive.add_to(*parser);
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
