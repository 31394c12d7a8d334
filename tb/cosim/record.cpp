/// The record run: what the tests do in small, long enough to be told. Prints figures:
/// name<TAB>value<TAB>bound<TAB>ok|short.
#include <cstdio>
#include <ctime>
#include <functional>
#include <stdexcept>

#include "tb/cosim/cosimulation.h"
#include "tb/cosim/cycle_table.h"
#include "tb/cosim/fault_campaign.h"
#include "tb/cosim/random_frames.h"
#include "tb/cosim/top.h"
#include "tb/cosim/video.h"

namespace floorline::cosim {
namespace {

void print(const char* name, double value, bool at_least, double bound) {
  const bool ok = at_least ? value >= bound : value <= bound;
  std::printf("cosim.%s\t%.10g\t%s %.10g\t%s\n", name, value, at_least ? ">=" : "<=", bound,
              ok ? "ok" : "short");
  std::fflush(stdout);
}

void print_faults() {
  constexpr int kInjections = 2000;
  FaultTally sum;
  for (const Stalls stalls : {Stalls::none, Stalls::light, Stalls::heavy}) {
    FaultCampaign campaign(stalls, 77);
    for (int i = 0; i < kInjections / 3 + 1; ++i) campaign.inject(static_cast<Fault>(i % kFaultKinds));
    const FaultTally& tally = campaign.tally();
    sum.injected += tally.injected;
    sum.hung += tally.hung;
    sum.wrong_frames += tally.wrong_frames;
    sum.uncounted += tally.uncounted;
    if (!tally.first.empty()) std::fprintf(stderr, "%s\n", tally.first.c_str());
  }
  print("faults_injected", sum.injected, true, kInjections);
  print("faults_hung", sum.hung, false, 0);
  print("faults_wrong_frames", sum.wrong_frames, false, 0);
  print("faults_uncounted", sum.uncounted, false, 0);
}

/// Small frames, of which every parameter, size and line table changes at random.
void print_soak() {
  constexpr int kFrames = 10000;
  RandomFrames random(0);
  cv::Size size;
  std::vector<LineSetup> lines;
  Job job;
  job.largest_frame = {640, 480};
  job.frame_count = kFrames;
  job.frame = [&](int index) {
    if (index == 0) random = RandomFrames(99);
    if (index == 0 || random.chance(0.1)) {
      size = random.size({64, 48});
      lines = random.lines(size);
    }
    return FrameInput{random.image(size), random.parameters(size), lines};
  };
  job.stalls = Stalls::light;
  job.seed = 99;
  job.waves = "cosim_soak.fst";
  const Result result = cosimulate(job);
  print("soak_frames", static_cast<double>(result.frames.size()), true, kFrames);
  print("soak_bit_differences", static_cast<double>(result.differences()), false, 0);
}

void print_cycles() {
  const CycleRow vga = measure_cycles({640, 480});
  print("cycles_per_frame", vga.frame_cycles, false, vga.size.area() + 1000);
  print("latency_cycles", vga.decision_latency, false, 2200);
}

/// Processor time, so that other programs on the machine do not count.
void print_speed() {
  constexpr int kFrames = 8;
  const cv::Size size(640, 480);
  RandomFrames random(4);
  Top top(Stalls::none, 0);
  Driver driver(top);
  FrameParameters parameters = random.parameters(size);
  parameters.width = size.width;
  parameters.height = size.height;
  driver.prepare(parameters, random.lines(size));
  driver.enable(true);
  for (int i = 0; i < kFrames; ++i) queue_video(random.image(size), 0, size.height, top.video().queue);
  const std::uint64_t first = top.cycles();
  const std::clock_t start = std::clock();
  top.run_until([&] { return top.obstacles().packets.size() == kFrames; });
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  print("cycles_per_second", static_cast<double>(top.cycles() - first) / seconds, true, 1.5e6);
}

}  // namespace
}  // namespace floorline::cosim

int main() {
  using namespace floorline::cosim;
  try {
    print_cycles();
    print_speed();
    print_faults();
    print_soak();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
