/// floorline report: everything about a sequence on one self-contained page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <opencv2/imgcodecs.hpp>

#include "command.h"
#include "output.h"
#include "report/hardware.h"
#include "report/html.h"
#include "report/picture.h"
#include "sequence_report.h"

namespace floorline::app {
namespace {

struct Options {
  std::string sequence;
  std::string output = "report.html";
  std::string picture;
  std::vector<std::string> hardware;
  int frames = 24;
  DriveOptions drive;
  Output results;
};

constexpr const char* footer =
    "Examples:\n"
    "  floorline report out/room --output out/room.html\n"
    "  floorline report out/room --output out/room.html --hardware out/cycles.json --picture out/room.png\n"
    "docs/report.md tells what the page shows and how a hardware file is made.";

void write_picture(const report::Document& document, const std::string& file) {
  const cv::Mat picture = report::compose_picture(document, report::liveliest_frame(document), "gaussian");
  std::vector<uchar> png;
  cv::imencode(".png", picture, png, {cv::IMWRITE_PNG_COMPRESSION, 9});
  produce_file(file, {reinterpret_cast<const char*>(png.data()), png.size()});
}

ExitCode run(const Options& options) {
  nlohmann::json hardware =
      nlohmann::json::array();  // read first: a fault there should not cost the whole run
  for (const std::string& file : options.hardware) {
    for (const nlohmann::json& section : report::read_hardware(file)) hardware.push_back(section);
  }
  report::Document document =
      make_document({options.sequence, options.drive.settings(), options.drive.poses(), options.frames});
  document.hardware = hardware;
  const std::string page = report::to_html(document);
  produce_file(options.output, page);
  if (!options.picture.empty()) write_picture(document, options.picture);
  options.results.text(fmt::format("{}: {} frames, {:.1f} MB", options.output, document.frames.size(),
                                   static_cast<double>(page.size()) / 1e6));
  options.results.json(
      {{"report", options.output}, {"frames", document.frames.size()}, {"bytes", page.size()}});
  return ExitCode::ok;
}

}  // namespace

Command add_report(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("report", "Write one HTML page about a sequence");
  parser->footer(footer);
  parser->add_option("SEQUENCE", options->sequence, "Sequence folder")->required();
  parser->add_option("--output", options->output, "The page to write")
      ->type_name("FILE")
      ->capture_default_str();
  parser->add_option("--frames", options->frames, "Most frames in the slider")
      ->check(CLI::Range(1, 60))
      ->capture_default_str();
  parser->add_option("--hardware", options->hardware, "Sections to add: cycles, resources")
      ->type_name("FILE.json");
  parser->add_option("--picture", options->picture, "Also one frame as a single picture")
      ->type_name("FILE.png");
  options->drive.add_to(*parser);
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
