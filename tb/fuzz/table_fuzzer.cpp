/// The readers of odometry.csv, KITTI poses and TUM trajectories.
#include "host/odometry.h"
#include "reader_contract.h"

namespace fuzz = floorline::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  file.fill(data, size);
  fuzz::load_or_refuse([] { floorline::read_odometry(file.path()); });
  fuzz::load_or_refuse([] { floorline::read_kitti_poses(file.path()); });
  fuzz::load_or_refuse([] {
    const auto trajectory = floorline::read_tum_trajectory(file.path());
    floorline::pose_at(trajectory, 0.25, 1.0);
  });
  return 0;
}
