/// floorline cosim: a sequence through the accelerator's Verilog, every bit against the C simulation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>

#include "command.h"
#include "cosim_report.h"
#include "drive.h"
#include "output.h"
#include "progress.h"
#include "tb/cosim/cosimulation.h"

namespace floorline::app {
namespace {

const std::map<std::string, cosim::Stalls> kStalls = {
    {"none", cosim::Stalls::none}, {"light", cosim::Stalls::light}, {"heavy", cosim::Stalls::heavy}};

struct Options {
  std::string sequence;
  std::string stalls = "none";
  std::uint64_t seed = 1;
  int frames = 0;
  std::string waves = "cosim.fst";
  std::string hardware;
  DriveOptions drive;
  Output results;
};

/// The frames of the sequence, from its start whenever frame 0 is asked for.
class SequenceFrames {
 public:
  explicit SequenceFrames(const Options& options) : options_(options) { restart(); }

  const Drive& drive() const { return *drive_; }

  cosim::FrameInput operator()(int index) {
    if (index == 0) restart();
    const DriveFrame frame = drive_->next();
    return {frame.image, frame.kernel, drive_->configuration().lines()};
  }

 private:
  void restart() {
    drive_ = std::make_unique<Drive>(options_.sequence, options_.drive.settings(), options_.drive.poses());
  }

  const Options& options_;
  std::unique_ptr<Drive> drive_;
};

nlohmann::json facts(const CosimSummary& s) {
  return {{"frames", s.frames()},
          {"stalls", s.stalls},
          {"differing_bits",
           {{"points", s.sum(&cosim::FrameVerdict::points)},
            {"obstacles", s.sum(&cosim::FrameVerdict::obstacles)},
            {"counts", s.sum(&cosim::FrameVerdict::counts)},
            {"taps", s.sum(&cosim::FrameVerdict::taps)},
            {"registers", s.sum(&cosim::FrameVerdict::registers)}}},
          {"points", s.sum(&cosim::FrameVerdict::point_count)},
          {"obstacles", s.sum(&cosim::FrameVerdict::obstacle_count)},
          {"cycles", s.result.cycles},
          {"most_cycles_per_frame", s.most_cycles()},
          {"most_first_result_latency", s.greatest(&HardwareCounters::first_result_latency)},
          {"most_decision_latency", s.greatest(&HardwareCounters::decision_latency)},
          {"seconds", s.result.seconds},
          {"cycles_per_second", s.result.cycles_per_second()},
          {"frames_per_second", static_cast<double>(s.frames()) / s.result.seconds}};
}

void print(const Options& options, const CosimSummary& s) {
  options.results.text(
      fmt::format("{}: {} frames of {}x{}, stalls {}: {} differing bits in {} points, {} obstacles, {} line "
                  "counts, {} elements of the taps and the registers",
                  options.sequence, s.frames(), s.size.width, s.size.height, s.stalls, s.result.differences(),
                  s.sum(&cosim::FrameVerdict::point_count), s.sum(&cosim::FrameVerdict::obstacle_count),
                  s.sum(&cosim::FrameVerdict::line_count), s.sum(&cosim::FrameVerdict::tap_count)));
  options.results.text(
      fmt::format("{} cycles a frame at most, {} from the deciding row to the point; {:.3g} million cycles a "
                  "second, {:.3g} frames a second",
                  s.most_cycles(), s.greatest(&HardwareCounters::decision_latency),
                  s.result.cycles_per_second() / 1e6, static_cast<double>(s.frames()) / s.result.seconds));
  if (const auto failure = s.result.first_failure()) {
    options.results.text(fmt::format("first difference in frame {}: {}; waves in {}", *failure,
                                     s.result.frames[*failure].first_difference->words, options.waves));
  }
}

ExitCode run(const Options& options) {
  SequenceFrames frames(options);
  const int available = frames.drive().frame_count();
  const int count = options.frames > 0 ? std::min(options.frames, available) : available;
  Progress progress("cosim");
  cosim::Job job;
  job.largest_frame = frames.drive().sequence().camera().size;
  job.frame_count = count;
  job.frame = std::ref(frames);
  job.stalls = kStalls.at(options.stalls);
  job.seed = options.seed;
  job.waves = options.waves;
  job.progress = [&](int done) { progress.advance(done, count); };
  const CosimSummary summary = {cosim::cosimulate(job), job.largest_frame, options.stalls};
  print(options, summary);
  options.results.json(facts(summary));
  if (!options.hardware.empty()) write_hardware_sections(summary, options.hardware);
  return summary.result.differences() == 0 ? ExitCode::ok : ExitCode::short_of_bound;
}

}  // namespace

Command add_cosim(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* parser =
      app.add_subcommand("cosim", "Run a sequence through the Verilog, every bit against the C simulation");
  parser->footer(
      "Examples:\n"
      "  floorline cosim out/room\n"
      "  floorline cosim out/room --stalls heavy --seed 7 --hardware out/cosim.json\n"
      "Exit code 1: a bit differs; the waves of the first such frame are saved. docs/cosimulation.md tells "
      "more.");
  parser->add_option("SEQUENCE", options->sequence, "Sequence folder")->required();
  parser->add_option("--stalls", options->stalls, "Random stalls on every port: none, light or heavy")
      ->check(CLI::IsMember({"none", "light", "heavy"}))
      ->capture_default_str();
  parser->add_option("--seed", options->seed, "Seed of the stalls")->capture_default_str();
  parser->add_option("--frames", options->frames, "The first so many frames; 0: all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  parser->add_option("--waves", options->waves, "Waves (FST) of the first frame that differs")
      ->type_name("FILE")
      ->capture_default_str();
  parser->add_option("--hardware", options->hardware, "Sections for floorline report --hardware")
      ->type_name("FILE");
  options->drive.add_to(*parser);
  options->results.add_option(*parser);
  return {parser, [options] { return run(*options); }};
}

}  // namespace floorline::app
