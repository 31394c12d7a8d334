/// floorline golden and floorline csim: one model over a sequence, its findings as files.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "command.h"
#include "host/atomic_file.h"
#include "model.h"
#include "output.h"
#include "progress.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

enum class Kind { golden, csim };

struct Options {
  Kind kind;
  std::string sequence;
  std::string output;
  bool stages = false;
  bool force = false;
  DriveOptions drive;
  Output results;
};

struct Summary {
  int frames = 0;
  int mature_frames = 0;
  std::size_t contacts = 0;
  std::size_t obstacles = 0;
  double model_seconds = 0;

  double frames_per_second() const { return frames / model_seconds; }
};

/// Rows of contacts.csv and obstacles.csv.
struct Tables {
  std::string contacts = "frame,mature,line,u,v,rows,clipped,x_m,y_m\n";
  std::string obstacles = "frame,mature,first_line,last_line,u,v,x_m,y_m\n";

  void add(const DriveFrame& frame, const Finding& finding) {
    const int mature = frame.plan.mature;
    for (const auto& [contact, x, y] : finding.points)
      contacts += fmt::format("{},{},{},{},{},{},{:d},{:.4f},{:.4f}\n", frame.index, mature, contact.line,
                              contact.u, contact.v, contact.rows, contact.clipped, x, y);
    for (const auto& [first, last, nearest] : finding.obstacles)
      obstacles += fmt::format("{},{},{},{},{},{},{:.4f},{:.4f}\n", frame.index, mature, first, last,
                               nearest.contact.u, nearest.contact.v, nearest.x, nearest.y);
  }
};

void write_pictures(const Model& model, int frame, const fs::path& folder) {
  for (const auto& [stage, picture] : model.pictures()) {
    fs::create_directories(folder / stage);
    write_image(folder / stage / fmt::format("{:06}.png", frame), picture);
  }
}

/// Runs the model over the whole sequence; writes into `folder` unless it is empty.
Summary run_sequence(const Options& options, const fs::path& folder) {
  Drive drive(options.sequence, options.drive.settings(), options.drive.poses());
  const std::unique_ptr<Model> model =
      options.kind == Kind::golden ? golden_model(drive) : csim_model(drive, options.stages);
  Progress progress(options.kind == Kind::golden ? "golden" : "csim");
  Summary summary;
  Tables tables;
  for (int i = 0; i < drive.frame_count(); ++i) {
    const DriveFrame frame = drive.next();
    const auto start = std::chrono::steady_clock::now();
    const Finding finding = model->run(frame);
    summary.model_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++summary.frames;
    summary.mature_frames += frame.plan.mature;
    summary.contacts += finding.points.size();
    summary.obstacles += finding.obstacles.size();
    tables.add(frame, finding);
    if (options.stages) write_pictures(*model, i, folder / "stages");
    progress.advance(i + 1, drive.frame_count());
  }
  if (folder.empty()) return summary;
  write_file(folder / "contacts.csv", tables.contacts);
  write_file(folder / "obstacles.csv", tables.obstacles);
  return summary;
}

Summary run_into_folder(const Options& options) {
  Summary summary;
  produce_folder(options.output, options.force, [&](const fs::path& fresh) {
    StagedFolder staged(fresh);
    summary = run_sequence(options, staged.path());
    staged.commit();
  });
  return summary;
}

ExitCode run(const Options& options) {
  const Summary summary = options.output.empty() ? run_sequence(options, {}) : run_into_folder(options);
  options.results.text(fmt::format(
      "{}: {} frames, {} with a mature baseline; {} contact points, {} obstacles; {:.3g} frames a second",
      options.sequence, summary.frames, summary.mature_frames, summary.contacts, summary.obstacles,
      summary.frames_per_second()));
  options.results.json({{"sequence", options.sequence},
                        {"frames", summary.frames},
                        {"mature_frames", summary.mature_frames},
                        {"contacts", summary.contacts},
                        {"obstacles", summary.obstacles},
                        {"frames_per_second", summary.frames_per_second()}});
  return ExitCode::ok;
}

Command add_model(CLI::App& app, Kind kind, const char* name, const char* description) {
  auto options = std::make_shared<Options>();
  options->kind = kind;
  CLI::App* parser = app.add_subcommand(name, description);
  parser->footer(fmt::format(
      "Examples:\n"
      "  floorline {0} out/room\n"
      "  floorline {0} out/room --output out/room-{0} --stages --baseline 4\n"
      "The output folder gets contacts.csv, obstacles.csv and, with --stages, stages/KERNEL/000000.png.",
      name));
  parser->add_option("SEQUENCE", options->sequence, "Sequence folder")->required();
  auto* output =
      parser->add_option("--output", options->output, "Folder for what was found")->type_name("FOLDER");
  parser->add_flag("--stages", options->stages, "Also a picture of every stage and frame")->needs(output);
  parser->add_flag("--force", options->force, "Replace the folder when it is there already")->needs(output);
  options->drive.add_to(*parser);
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace

Command add_golden(CLI::App& app) {
  return add_model(app, Kind::golden, "golden", "Run the floating-point model over a sequence");
}

Command add_csim(CLI::App& app) {
  return add_model(app, Kind::csim, "csim", "Run the fixed-point kernels in C simulation over a sequence");
}

}  // namespace floorline::app
