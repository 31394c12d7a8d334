/// The record runs: what the tests do in small, long enough to be told. Usage: cosim_record
/// cycles|faults|soak, or cosim_record pictures FOLDER... Prints figures:
/// name<TAB>value<TAB>bound<TAB>ok|short.
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/image_file.h"
#include "tb/cosim/cosimulation.h"
#include "tb/cosim/cycle_table.h"
#include "tb/cosim/fault_campaign.h"
#include "tb/cosim/random_frames.h"

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

/// Small frames of random scenes.
void print_soak() {
  constexpr int kFrames = 10000;
  RandomFrames random(0);
  Job job;
  job.largest_frame = {640, 480};
  job.frame_count = kFrames;
  job.frame = [&](int index) {
    if (index == 0) random = RandomFrames(99);
    if (index == 0 || random.chance(0.1)) random.begin_scene(random.size({64, 48}));
    return random.next();
  };
  job.stalls = Stalls::light;
  job.seed = 99;
  job.waves = "cosim_soak.fst";
  const Result result = cosimulate(job);
  print("soak_frames", static_cast<double>(result.frames.size()), true, kFrames);
  print("soak_bit_differences", static_cast<double>(result.differences()), false, 0);
}

/// Every picture of these folders twice, at most VGA of it, under random parameters.
void print_pictures(const std::vector<std::string>& folders) {
  constexpr std::uint64_t kSeed = 31;
  std::vector<cv::Mat> pictures;
  for (const std::string& folder : folders) {
    for (const std::filesystem::path& file : image_files(folder)) {
      const cv::Mat picture = read_image(file);
      pictures.push_back(picture(cv::Rect({}, picture.size()) & cv::Rect(0, 0, 640, 480)).clone());
    }
  }
  for (const Stalls stalls : {Stalls::none, Stalls::light, Stalls::heavy}) {
    RandomFrames random(kSeed);
    std::vector<LineSetup> lines;
    const auto frame = [&](int index) {
      const cv::Mat& picture = pictures[index / 2];
      if (index % 2 == 0) lines = random.lines(picture.size());
      return FrameInput{picture, random.parameters(picture.size()), lines};
    };
    const int count = 2 * static_cast<int>(pictures.size());
    const Result result = cosimulate({{640, 480}, count, frame, stalls, kSeed, {}, {}});
    print((std::string("bit_differences.unit_") + name(stalls)).c_str(),
          static_cast<double>(result.differences()), false, 0);
  }
  print("pictures", static_cast<double>(pictures.size()), true, 1);
}

void print_cycles() {
  const CycleRow vga = measure_cycles({640, 480}, Stalls::none);
  print("cycles_per_frame", vga.frame_cycles, false, vga.size.area() + 1000);
  print("latency_cycles", vga.decision_latency, false, 2200);
}

}  // namespace
}  // namespace floorline::cosim

int main(int count, char** arguments) {
  using namespace floorline::cosim;
  const std::vector<std::string> words(arguments + 1, arguments + count);
  const std::map<std::string, void (*)()> parts = {
      {"cycles", print_cycles}, {"faults", print_faults}, {"soak", print_soak}};
  try {
    if (words.size() == 1 && parts.contains(words[0])) {
      parts.at(words[0])();
    } else if (words.size() > 1 && words[0] == "pictures") {
      print_pictures({words.begin() + 1, words.end()});
    } else {
      std::fprintf(stderr, "error: name the part to record: cycles, faults, soak, or pictures FOLDER...\n");
      return 2;
    }
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
