/// Whether the bench finds seeded bugs (scripts/mutate.py): a line a bug, number, place, change and what
/// found it, or "missed".
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <set>

#include "Vfloorline_top_mutants.h"
#include "tb/cosim/cosimulation.h"
#include "tb/cosim/cycle_table.h"
#include "tb/cosim/fault_campaign.h"
#include "tb/cosim/random_frames.h"
#include "tb/cosim/verilated_top.h"

namespace floorline::cosim {
namespace {

int living_mutant = 0;

class MutantTop final : public VerilatedTop<Vfloorline_top_mutants> {
 public:
  explicit MutantTop(std::uint64_t seed) : VerilatedTop(seed) { verilated().mutant = living_mutant; }
};

using Finding = std::optional<std::string>;

/// Frames whose size, lines and parameters change every fourth frame.
Finding by_frames(int frames, cv::Size largest, Stalls stalls) {
  constexpr std::uint64_t kSeed = 21;
  RandomFrames random(kSeed);
  cv::Size size;
  std::vector<LineSetup> lines;
  const auto frame = [&](int index) {
    if (index % 4 == 0) {
      size = random.size(largest);
      lines = random.lines(size);
    }
    return FrameInput{random.image(size), random.parameters(size), lines};
  };
  const Result result = cosimulate({{640, 480}, frames, frame, stalls, kSeed, {}, {}});
  for (const FrameVerdict& verdict : result.frames) {
    if (verdict.differences() != 0) return verdict.first_difference;
  }
  return {};
}

Finding by_faults(Stalls stalls) {
  FaultCampaign campaign(stalls, 5);
  for (int i = 0; i < 4 * kFaultKinds && campaign.tally().first.empty(); ++i) {
    campaign.inject(static_cast<Fault>(i % kFaultKinds));
  }
  if (campaign.tally().first.empty()) return {};
  return campaign.tally().first;
}

std::vector<CycleRow> cycle_rows() {
  std::vector<CycleRow> rows;
  for (const cv::Size size : {cv::Size(64, 48), cv::Size(320, 96)}) rows.push_back(measure_cycles(size));
  return rows;
}

/// The bench from its cheapest part on, up to the first that finds something.
Finding find(const std::vector<CycleRow>& right_cycles) {
  try {
    for (const Stalls stalls : {Stalls::none, Stalls::heavy}) {
      if (const Finding frames = by_frames(96, {128, 80}, stalls)) return frames;
      if (const Finding faults = by_faults(stalls)) return faults;
    }
    // Sums of large frames fill more bits.
    if (const Finding frames = by_frames(12, {480, 320}, Stalls::none)) return frames;
    if (cycle_rows() != right_cycles) return "the table of cycles differs";
  } catch (const std::runtime_error& error) {  // A hang, a broken rule of AXI, a refused register.
    return error.what();
  }
  return {};
}

int run(const std::set<int>& wanted) {
  const std::vector<CycleRow> right_cycles = cycle_rows();
  if (const Finding finding = find(right_cycles)) {
    std::fprintf(stderr, "error: the RTL without a seeded bug fails: %s\n", finding->c_str());
    return 1;
  }
  std::ifstream table(MUTANTS_TABLE);
  for (std::string mutant; std::getline(table, mutant);) {
    ++living_mutant;
    if (!wanted.empty() && !wanted.contains(living_mutant)) continue;
    std::printf("%s\t%s\n", mutant.c_str(), find(right_cycles).value_or("missed").c_str());
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

std::unique_ptr<TopModel> make_model(Configuration, std::uint64_t seed) {
  return std::make_unique<MutantTop>(seed);
}

}  // namespace floorline::cosim

int main(int count, char** arguments) {
  std::set<int> wanted;
  for (int i = 1; i < count; ++i) wanted.insert(std::atoi(arguments[i]));
  return floorline::cosim::run(wanted);
}
