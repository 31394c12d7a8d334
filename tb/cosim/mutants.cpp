/// Whether the bench finds seeded bugs (scripts/mutate.py): a line a bug, number, place, change and what
/// found it, or "missed".
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
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

/// Scenes of four frames of sizes from `size()`.
Finding by_frames(int frames, const std::function<cv::Size(RandomFrames&)>& size, Stalls stalls) {
  constexpr std::uint64_t kSeed = 21;
  RandomFrames random(kSeed);
  const auto frame = [&](int index) {
    if (index % 4 == 0) random.begin_scene(size(random));
    return random.next();
  };
  const Result result = cosimulate({{640, 480}, frames, frame, stalls, kSeed, {}, {}});
  for (const FrameVerdict& verdict : result.frames) {
    if (verdict.differences() != 0) return verdict.first_difference->words;
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
  for (const CycleCase& some : cycle_cases()) {
    if (some.size.area() < 160 * 128) rows.push_back(measure_cycles(some.size, some.stalls));
  }
  return rows;
}

/// The bench from its cheapest part on, up to the first that finds something.
Finding find(const std::vector<CycleRow>& right_cycles) {
  try {
    const auto small = [](RandomFrames& random) { return random.size({128, 80}); };
    for (const Stalls stalls : {Stalls::none, Stalls::heavy}) {
      if (const Finding frames = by_frames(160, small, stalls)) return frames;
      if (const Finding faults = by_faults(stalls)) return faults;
    }
    if (cycle_rows() != right_cycles) return "the table of cycles differs";
    // Sums and rows of the largest frames fill every bit.
    const auto largest = [](RandomFrames&) { return cv::Size(640, 480); };
    if (const Finding frames = by_frames(24, largest, Stalls::none)) return frames;
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
