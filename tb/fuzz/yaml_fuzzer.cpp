/// The readers of camera, mount, settings and sequence files.
#include "apps/settings_file.h"
#include "host/camera.h"
#include "host/mount.h"
#include "host/sequence.h"
#include "reader_contract.h"

namespace {

namespace fs = std::filesystem;
namespace fuzz = floorline::fuzz;

/// A sequence of one frame whose sequence.yaml is the input.
class SequenceAround {
 public:
  explicit SequenceAround(const fs::path& input) {
    floorline::Camera camera;
    camera.size = {16, 12};
    camera.matrix << 20, 0, 8, 0, 20, 6, 0, 0, 1;
    floorline::SequenceWriter writer(folder_, {"fuzz", 10, "fuzzer"}, camera,
                                     floorline::robot_from_camera({.height_m = 0.5}));
    writer.add({.image = cv::Mat::zeros(camera.size, CV_8U),
                .odometry = {},
                .world_from_robot = {},
                .truth_mask = {}});
    writer.finish();
    fs::remove(folder_ / "sequence.yaml");
    fs::create_symlink(input, folder_ / "sequence.yaml");
  }
  ~SequenceAround() { fs::remove_all(folder_); }
  SequenceAround(const SequenceAround&) = delete;

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("floorline_fuzz." + std::to_string(getpid()));
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file;
  static const SequenceAround sequence(file.path());
  file.fill(data, size);
  fuzz::load_or_refuse([] { floorline::read_camera(file.path()); });
  fuzz::load_or_refuse([] { floorline::read_mount(file.path()); });
  fuzz::load_or_refuse([] {
    floorline::Settings settings;
    floorline::app::read_settings(file.path(), settings);
  });
  fuzz::load_or_refuse([] { floorline::Sequence{sequence.folder()}; });
  return 0;
}
