/// floorline import: a foreign recording as a sequence folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "sequence_import.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

using Open = Recording (*)(const fs::path&, const ImportFiles&);
const std::map<std::string, Open> formats = {
    {"kitti", open_kitti}, {"images", open_images}, {"tum", open_tum}, {"video", open_video}};

struct Options {
  std::string format;
  std::string source;
  std::string output;
  ImportFiles files;
  bool force = false;
  Output results;
};

constexpr const char* footer =
    "Formats:\n"
    "  kitti   folder with image_0/, calib.txt, poses.txt and plane.txt (or --mount)\n"
    "  images  folder of images; needs --camera, --mount and --odometry\n"
    "  tum     folder with rgb/ and groundtruth.txt; needs --camera\n"
    "  video   a clip; needs --camera, --mount and --odometry\n"
    "Examples:\n"
    "  floorline import kitti ../shared/data/kitti_odo06 --output out/kitti06\n"
    "  floorline import video clip.mp4 --camera camera.yaml --mount mount.yaml --odometry odometry.csv "
    "--output out/clip";

ExitCode run(const Options& options) {
  const Recording recording = formats.at(options.format)(options.source, options.files);
  const int frames = static_cast<int>(recording.odometry.size());
  produce_folder(options.output, options.force, [&](const fs::path& fresh) {
    Progress progress("import " + recording.name, frames);
    write_sequence(recording, fresh, [&](int done) { progress.advance(done); });
  });
  const cv::Size size = recording.camera.size;
  options.results.text(
      fmt::format("{}: {} frames of {} x {}", options.output, frames, size.width, size.height));
  options.results.json(
      {{"folder", options.output}, {"frames", frames}, {"width", size.width}, {"height", size.height}});
  return ExitCode::ok;
}

}  // namespace

Command add_import(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("import", "Turn a recording into a sequence folder");
  parser->footer(footer);
  std::vector<std::string> names;
  for (const auto& [name, open] : formats) names.push_back(name);
  parser->add_option("FORMAT", options->format, "kitti, images, tum or video")
      ->required()
      ->check(CLI::IsMember(names));
  parser->add_option("SOURCE", options->source, "The recording")->required();
  parser->add_option("--camera", options->files.camera, "Calibration: OpenCV YAML or ROS camera_info")
      ->type_name("FILE");
  parser->add_option("--mount", options->files.mount, "robot_from_camera, 4x4 (docs/architecture.md)")
      ->type_name("FILE");
  parser->add_option("--odometry", options->files.odometry, "frame,timestamp_s,x_m,y_m,yaw_rad")
      ->type_name("FILE");
  parser->add_option("--output", options->output, "Sequence folder to write")
      ->type_name("FOLDER")
      ->required();
  parser->add_flag("--force", options->force, "Replace the folder when it is there already");
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
