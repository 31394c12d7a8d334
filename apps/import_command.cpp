/// floorline import: a foreign recording as a sequence folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command.h"
#include "host/import.h"
#include "host/sequence.h"
#include "output.h"
#include "progress.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string format;
  std::string source;
  std::string output;
  Companions companions;
  bool force = false;
  Output results;
};

constexpr const char* footer =
    "Formats:\n"
    "  kitti   folder with image_0/, calib.txt, poses.txt and plane.txt\n"
    "  images  folder of images; needs --camera, --mount and --odometry\n"
    "  tum     folder with rgb/ and groundtruth.txt; needs --camera\n"
    "  video   a clip; needs --camera, --mount and --odometry\n"
    "Examples:\n"
    "  floorline import kitti ../shared/data/kitti_odo06 --output out/kitti06\n"
    "  floorline import video clip.mp4 --camera camera.yaml --mount mount.yaml --odometry odometry.csv "
    "--output out/clip";

/// What the recording itself does not say must be given.
void require(const fs::path& file, const Options& options, const char* option) {
  if (file.empty()) throw CLI::RequiredError(fmt::format("import {}: {}", options.format, option));
}

void import_into(const Options& options, const fs::path& folder, const ImportProgress& progress) {
  if (options.format == "kitti") return import_kitti(options.source, folder, progress);
  require(options.companions.camera, options, "--camera");
  if (options.format == "tum") return import_tum(options.source, options.companions.camera, folder, progress);
  require(options.companions.mount, options, "--mount");
  require(options.companions.odometry, options, "--odometry");
  const auto import = options.format == "images" ? import_images : import_video;
  import(options.source, options.companions, folder, progress);
}

ExitCode run(const Options& options) {
  produce_folder(options.output, options.force, [&](const fs::path& fresh) {
    Progress progress("import " + options.format);
    import_into(options, fresh, [&](int done, int total) {
      progress.advance(done, total);
      return true;
    });
  });
  const Sequence sequence(options.output);
  const cv::Size size = sequence.camera().size;
  options.results.text(fmt::format("{}: {} frames of {} x {}", options.output, sequence.frame_count(),
                                   size.width, size.height));
  options.results.json({{"folder", options.output},
                        {"frames", sequence.frame_count()},
                        {"width", size.width},
                        {"height", size.height}});
  return ExitCode::ok;
}

}  // namespace

Command add_import(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser = app.add_subcommand("import", "Turn a recording into a sequence folder");
  parser->footer(footer);
  parser->add_option("FORMAT", options->format, "kitti, images, tum or video")
      ->required()
      ->check(CLI::IsMember({"kitti", "images", "tum", "video"}));
  parser->add_option("SOURCE", options->source, "The recording")->required();
  parser->add_option("--camera", options->companions.camera, "Calibration: OpenCV YAML or ROS camera_info")
      ->type_name("FILE");
  parser->add_option("--mount", options->companions.mount, "robot_from_camera, 4x4 (docs/architecture.md)")
      ->type_name("FILE");
  parser->add_option("--odometry", options->companions.odometry, "frame,timestamp_s,x_m,y_m,yaw_rad")
      ->type_name("FILE");
  parser->add_option("--output", options->output, "Sequence folder to write")
      ->type_name("FOLDER")
      ->required();
  parser->add_flag("--force", options->force, "Replace the folder when it is there already");
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
