/// The gates that Yosys makes of a small floorline_top against the C simulation. Compiled for one target:
/// GATES is the Verilator class of its netlist, TARGET its name. Prints a figure.
#include <cstdio>
#include <stdexcept>

#include "tb/cosim/cosimulation.h"
#include "tb/cosim/random_frames.h"
#include "tb/cosim/verilated_top.h"
#include GATES_HEADER

namespace floorline::cosim {
namespace {

int run() {
  constexpr int kFrames = 4;
  constexpr std::uint64_t kSeed = 8;
  // Half of the small core's height: its frame ring, which is shorter, then forgets no row sooner than that
  // of VGA.
  const cv::Size size(40, 24);
  RandomFrames random(kSeed);
  const std::vector<LineSetup> lines = random.lines(size);
  const auto frame = [&](int) { return FrameInput{random.image(size), random.parameters(size), lines}; };
  const Result result = cosimulate({size, kFrames, frame, Stalls::light, kSeed, {}, {}});
  for (const FrameVerdict& verdict : result.frames) {
    if (!verdict.first_difference.empty()) std::fprintf(stderr, "%s\n", verdict.first_difference.c_str());
  }
  std::printf("cosim.gate_level_differences.%s\t%ld\t<= 0\t%s\n", TARGET, result.differences(),
              result.differences() == 0 ? "ok" : "short");
  return 0;
}

}  // namespace

std::unique_ptr<TopModel> make_model(Configuration, std::uint64_t seed) {
  return std::make_unique<VerilatedTop<GATES>>(seed);
}

}  // namespace floorline::cosim

int main() {
  try {
    return floorline::cosim::run();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
