/// The time that a frame of a sequence takes, on one core: golden model, C simulation, and the accelerator's
/// Verilog in Verilator. Usage: frame_benchmark SEQUENCE [options of Google Benchmark].
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <opencv2/core/utility.hpp>
#include <vector>

#include "golden/pipeline.h"
#include "host/error.h"
#include "host/parameters.h"
#include "host/sequence.h"
#include "tb/cosim/top.h"
#include "tb/cosim/video.h"
#include "tb/csim/csim.h"

namespace floorline {
namespace {

struct Frame {
  cv::Mat image;
  golden::Parameters golden;
  FrameParameters kernel;
};

/// A sequence with default settings, ready to be computed again and again.
struct Drive {
  cv::Size size;
  int ring_rows;
  std::vector<LineSetup> lines;
  std::vector<Frame> frames;
};

Drive load(const std::filesystem::path& folder) {
  constexpr int most_frames = 12;
  const Sequence sequence(folder);
  const Configuration configuration(sequence.camera(), sequence.robot_from_camera(), Settings());
  ReferencePlan plan = configuration.reference_plan();
  const std::vector<Eigen::Isometry3d> poses = sequence.world_from_robot(PoseSource::odometry);
  Drive drive{sequence.camera().size, configuration.ring_rows(), configuration.lines(), {}};
  for (int i = 0; i < std::min(most_frames, sequence.frame_count()); ++i) {
    const PlannedFrame planned = plan.next(poses[i]);
    const cv::Mat image = sequence.frame(i);
    drive.frames.push_back({image, configuration.golden_parameters(planned),
                            configuration.frame_parameters(planned, image.channels() == 1)});
    FrameParameters& kernel = drive.frames.back().kernel;
    kernel.width = image.cols;
    kernel.height = image.rows;
  }
  return drive;
}

void golden_model(benchmark::State& state, const Drive& drive) {
  for (auto _ : state) {
    golden::Pipeline pipeline(drive.ring_rows);
    for (const Frame& frame : drive.frames) {
      benchmark::DoNotOptimize(pipeline.process(frame.image, frame.golden).obstacles.size());
    }
  }
}

void c_simulation(benchmark::State& state, const Drive& drive) {
  for (auto _ : state) {
    CSimulation csim(drive.size);
    for (const Frame& frame : drive.frames) {
      benchmark::DoNotOptimize(csim.run(frame.image, frame.kernel, drive.lines).obstacles.size());
    }
  }
}

void verilator_model(benchmark::State& state, const Drive& drive) {
  std::uint64_t cycles = 0;
  for (auto _ : state) {
    cosim::Top top(cosim::configuration_for(drive.size), cosim::Stalls::none, 0);
    Driver driver(top);
    driver.enable(true);
    for (const Frame& frame : drive.frames) {
      driver.prepare(frame.kernel, drive.lines);
      cosim::queue_video(frame.image, 0, drive.size.height, top.video().queue);
      top.run_until([&] { return driver.prepared_frame_started(); });
    }
    top.run_until([&] { return top.obstacles().packets.size() == drive.frames.size(); });
    cycles += top.cycles();
  }
  state.counters["cycles_per_second"] = benchmark::Counter(double(cycles), benchmark::Counter::kIsRate);
}

void measure(const char* name, void (*way)(benchmark::State&, const Drive&), const Drive& drive) {
  benchmark::RegisterBenchmark(name, [way, &drive](benchmark::State& state) {
    way(state, drive);
    const auto frames = static_cast<double>(drive.frames.size());
    state.counters["frames_per_second"] =
        benchmark::Counter(frames, benchmark::Counter::kIsIterationInvariantRate);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace floorline

int main(int count, char** arguments) {
  using namespace floorline;
  benchmark::Initialize(&count, arguments);
  if (count != 2) {
    std::fprintf(stderr, "usage: frame_benchmark SEQUENCE [options of Google Benchmark]\n");
    return 2;
  }
  cv::setNumThreads(1);
  try {
    const Drive drive = load(arguments[1]);
    measure("golden", golden_model, drive);
    measure("csim", c_simulation, drive);
    measure("cosim", verilator_model, drive);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
