#include "drive.h"

#include <CLI/CLI.hpp>

#include "golden/luma.h"
#include "settings_file.h"

namespace floorline::app {

void DriveOptions::add_to(CLI::App& parser) {
  parser.add_option("--settings", file_, "settings.yaml; docs/command.md lists its keys")->type_name("FILE");
  parser.add_option("--rule", rule_, "run: the default; paper: all settings of the ICVS paper")
      ->check(CLI::IsMember({"run", "paper"}));
  parser
      .add_option("--baseline", baseline_,
                  "Frames between the reference and the current image; 0: as odometry asks")
      ->check(CLI::Range(0, 100000))
      ->type_name("K");
  parser.add_option("--poses", poses_, "odometry: as the wheels tell; exact: poses.txt")
      ->check(CLI::IsMember({"odometry", "exact"}))
      ->capture_default_str();
}

Settings DriveOptions::settings() const {
  Settings settings = rule_ == "paper" ? paper_settings() : Settings();
  if (!file_.empty()) read_settings(file_, settings);
  if (baseline_) settings.reference.every = *baseline_;
  return settings;
}

Drive::Drive(const std::filesystem::path& sequence_folder, const Settings& settings, PoseSource poses)
    : sequence_(sequence_folder),
      configuration_(sequence_.camera(), sequence_.robot_from_camera(), settings),
      world_from_robot_(sequence_.world_from_robot(poses)),
      plan_(configuration_.reference_plan()),
      lens_(configuration_.lens()) {}

DriveFrame Drive::next() {
  DriveFrame frame;
  frame.index = next_;
  frame.timestamp_s = sequence_.timestamp_s(next_);
  frame.image = sequence_.frame(next_);
  if (lens_) frame.image = lens_->rectify(golden::luma(frame.image));
  frame.world_from_robot = world_from_robot_[next_];
  frame.plan = plan_.next(frame.world_from_robot);
  frame.golden = configuration_.golden_parameters(frame.plan);
  frame.kernel = configuration_.frame_parameters(frame.plan, frame.image.channels() == 1);
  ++next_;
  return frame;
}

}  // namespace floorline::app
