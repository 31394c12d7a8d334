/// Small frames as JSON for benches in other languages: what to write into registers, pixels, and what must
/// come out. Usage: cosim_vectors FRAMES.
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "host/driver.h"
#include "rtl/floorline_registers.h"
#include "tb/cosim/comparison.h"
#include "tb/cosim/random_frames.h"
#include "tb/cosim/video.h"
#include "tb/csim/csim.h"

namespace floorline::cosim {
namespace {

/// Answers as an idle core of VGA would and remembers what is written.
class RecordingBus : public RegisterBus {
 public:
  std::uint32_t read32(std::uint32_t offset) override {
    constexpr std::uint32_t kVgaLimits = 8u << 24 | 480u << 12 | 640u;
    if (offset == FLOORLINE_ID) return FLOORLINE_ID_VALUE;
    if (offset == FLOORLINE_VERSION) return FLOORLINE_VERSION_VALUE;
    return offset == FLOORLINE_LIMITS ? kVgaLimits : 0;
  }
  void write32(std::uint32_t offset, std::uint32_t value) override { writes.push_back({offset, value}); }

  nlohmann::json writes = nlohmann::json::array();
};

/// Elements as hexadecimal numbers.
nlohmann::json hexadecimal(const std::vector<PackedElement>& elements) {
  nlohmann::json list = nlohmann::json::array();
  for (const PackedElement& e : elements) {
    char text[33];
    std::snprintf(text, sizeof text, "%08x%08x%08x%08x", e[3], e[2], e[1], e[0]);
    list.push_back(text);
  }
  return list;
}

nlohmann::json vectors(int frame_count, std::uint64_t seed) {
  const cv::Size size(40, 20);
  RandomFrames random(seed);
  RecordingBus bus;
  Driver driver(bus);
  CSimulation csim(size);
  const std::vector<LineSetup> lines = random.lines(size);
  nlohmann::json frames = nlohmann::json::array();
  for (int i = 0; i < frame_count; ++i) {
    const cv::Mat image = random.image(size);
    FrameParameters parameters = random.parameters(size);
    parameters.width = size.width;
    parameters.height = size.height;
    parameters.grey = image.channels() == 1;
    driver.prepare(parameters, lines);
    std::deque<VideoBeat> beats;
    queue_video(image, 0, size.height, beats);
    nlohmann::json pixels = nlohmann::json::array();
    for (const VideoBeat& beat : beats) pixels.push_back(beat.data);
    const ExpectedFrame expected(csim, image, parameters, lines);
    frames.push_back({{"width", size.width},
                      {"writes", std::exchange(bus.writes, nlohmann::json::array())},
                      {"pixels", pixels},
                      {"points", hexadecimal(expected.points)},
                      {"obstacles", hexadecimal(expected.obstacles)},
                      {"counts", hexadecimal(expected.counts)},
                      {"null_pixels", expected.status.null_pixels},
                      {"threshold_used", expected.status.threshold_used}});
  }
  return frames;
}

}  // namespace
}  // namespace floorline::cosim

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "error: give the number of frames and a seed.\n");
    return 2;
  }
  std::puts(floorline::cosim::vectors(std::atoi(arguments[1]), std::atoi(arguments[2])).dump().c_str());
}
