/// floorline mount: height, pitch and roll of the camera, fitted from the images of a drive.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>

#include "command.h"
#include "golden/luma.h"
#include "host/mount.h"
#include "host/mount_fit.h"
#include "host/parameters.h"
#include "host/sequence.h"
#include "output.h"
#include "progress.h"

namespace floorline::app {
namespace {

struct Options {
  std::string sequence;
  std::string output;
  bool exact_poses = false;
  Output results;
};

constexpr const char* footer =
    "The fit starts from the mount.yaml of the sequence, which must be right to some three degrees and a "
    "tenth "
    "of the height;\n"
    "yaw and an offset to the side stay 0. The robot must drive farther than a quarter of the camera's "
    "height.\n"
    "Example:\n"
    "  floorline mount out/clip --output mount.yaml";

double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }

/// All frames, grey and rectified.
std::vector<cv::Mat> grey_frames(const Sequence& sequence) {
  const std::optional<golden::Lens> lens = rectification(sequence.camera());
  std::vector<cv::Mat> frames;
  Progress progress("read");
  for (int i = 0; i < sequence.frame_count(); ++i) {
    const cv::Mat grey = golden::luma(sequence.frame(i));
    frames.push_back(lens ? lens->rectify(grey) : grey);
    progress.advance(i + 1, sequence.frame_count());
  }
  return frames;
}

std::string text(const char* name, const MountAngles& angles, double residual) {
  return fmt::format(
      "{}: height {:.3f} m, pitch {:.2f} deg, roll {:.2f} deg, floor differs by {:.2f} grey levels", name,
      angles.height_m, degrees(angles.pitch_rad), degrees(angles.roll_rad), residual);
}

nlohmann::json facts(const MountAngles& angles, double residual) {
  return {{"height_m", angles.height_m},
          {"pitch_deg", degrees(angles.pitch_rad)},
          {"roll_deg", degrees(angles.roll_rad)},
          {"residual", residual}};
}

ExitCode run(const Options& options) {
  const Sequence sequence(options.sequence);
  const MountAngles before = mount_angles(sequence.robot_from_camera());
  const auto poses =
      sequence.world_from_robot(options.exact_poses ? PoseSource::poses : PoseSource::odometry);
  const MountFit fit = fit_mount(sequence.camera(), before, grey_frames(sequence), poses);
  options.results.text(text("before", before, fit.residual_before));
  options.results.text(text("fitted", fit.angles, fit.residual));
  options.results.json({{"before", facts(before, fit.residual_before)},
                        {"fitted", facts(fit.angles, fit.residual)},
                        {"pairs", fit.pairs}});
  if (!options.output.empty()) write_mount(robot_from_camera(fit.angles), options.output);
  return ExitCode::ok;
}

}  // namespace

Command add_mount(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser =
      app.add_subcommand("mount", "Fit height, pitch and roll of the camera to the images of a drive");
  parser->footer(footer);
  parser->add_option("SEQUENCE", options->sequence, "Sequence folder")->required();
  parser->add_flag("--exact-poses", options->exact_poses,
                   "Motion from poses.txt instead of the odometry (KITTI)");
  parser->add_option("--output", options->output, "mount.yaml to write")->type_name("FILE");
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
