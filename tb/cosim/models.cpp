#include "Vfloorline_top.h"
#include "Vfloorline_top___024root.h"
#include "Vfloorline_top_wide.h"
#include "Vfloorline_top_wide___024root.h"
#include "tb/cosim/verilated_top.h"

namespace floorline::cosim {
namespace {

/// With counters on the stages and the FIFOs between them. They look at registers of rtl/lib through
/// Verilator's names for them, so that the RTL needs no counters for it.
template <typename Verilated>
class CountedTop final : public VerilatedTop<Verilated> {
 public:
  using VerilatedTop<Verilated>::VerilatedTop;

  bool tick(Agents& agents, std::uint64_t cycle) override {
    const bool moved = VerilatedTop<Verilated>::tick(agents, cycle);
    count_channels();
    count_stages();
    return moved;
  }

  Activity take_activity() override {
    const Activity activity = {{channels_.begin(), channels_.end()}, {stages_.begin(), stages_.end()}};
    channels_ = {};
    for (StageRun& stage : stages_) stage.longest = 0;
    return activity;
  }

 private:
  void count_channels() {
    const auto& root = *this->verilated().rootp;
    auto next = channels_.begin();
    const auto hold = [&](const char* name, std::uint32_t depth, std::uint32_t words, bool not_empty,
                          bool not_full) {
      ChannelCounts& channel = *next++;
      channel.name = name;
      channel.depth = depth;
      ++channel.cycles;
      channel.empty += !not_empty;
      channel.full += !not_full;
      channel.most = std::max(channel.most, words);
    };
#define FIFO(name, part) root.floorline_top__DOT__core__DOT__##name##_fifo__DOT__##part
#define PAIR(name, part) FIFO(name, registers__DOT__pair__DOT__##part)
#define HOLD_PAIR(name)                                                                                    \
  hold(#name, 2, PAIR(name, output_valid_reg) + !PAIR(name, spare_free_reg), PAIR(name, output_valid_reg), \
       PAIR(name, spare_free_reg))
#define HOLD_REGISTER(name)                                                                  \
  hold(#name, 1, FIFO(name, register__DOT__valid_reg), FIFO(name, register__DOT__valid_reg), \
       !FIFO(name, register__DOT__valid_reg))
#define HOLD_RAM(name, depth)                                                                   \
  hold(#name, depth, FIFO(name, ram__DOT__stored_reg) + FIFO(name, ram__DOT__output_valid_reg), \
       FIFO(name, ram__DOT__output_valid_reg), FIFO(name, ram__DOT__not_full_reg))
    HOLD_PAIR(luma_out);
    HOLD_PAIR(pairs);
    HOLD_PAIR(difference_out);
    HOLD_PAIR(changes);
    HOLD_RAM(motions, 4096);
    HOLD_PAIR(blurred);
    HOLD_PAIR(measured);
    HOLD_PAIR(thresholds);
    HOLD_PAIR(binary);
    HOLD_PAIR(eroded);
    HOLD_PAIR(region);
    HOLD_RAM(contacts, 64);
    HOLD_REGISTER(floor_points);
    HOLD_RAM(candidates, 16);
#undef HOLD_RAM
#undef HOLD_REGISTER
#undef HOLD_PAIR
#undef PAIR
#undef FIFO
  }

  /// Between two frames a stage is in state 0, S_IDLE, for a cycle at least.
  void count_stages() {
    const auto& root = *this->verilated().rootp;
    std::size_t next = 0;
    const auto run = [&](const char* name, bool busy) {
      std::uint32_t& running = running_[next];
      StageRun& stage = stages_[next++];
      stage.name = name;
      if (busy) {
        ++running;
      } else if (running != 0) {
        stage.longest = std::max(stage.longest, std::exchange(running, 0));
      }
    };
#define STAGE(name) run(#name, root.floorline_top__DOT__core__DOT__##name##__DOT__state != 0)
    STAGE(luma);
    STAGE(frame_ring);
    STAGE(difference);
    STAGE(displacement);
    STAGE(gaussian);
    STAGE(otsu);
    STAGE(binarize);
    STAGE(erode);
    STAGE(roi);
    STAGE(polar);
    STAGE(birdseye);
    STAGE(cluster);
#undef STAGE
  }

  std::array<ChannelCounts, 14> channels_ = {};
  std::array<StageRun, 12> stages_ = {};
  std::array<std::uint32_t, 12> running_ = {};  ///< Cycles since a stage's start; 0: it waits for one.
};

}  // namespace

std::unique_ptr<TopModel> make_model(Configuration configuration, std::uint64_t seed) {
  if (configuration == Configuration::vga) return std::make_unique<CountedTop<Vfloorline_top>>(seed);
  return std::make_unique<CountedTop<Vfloorline_top_wide>>(seed);
}

}  // namespace floorline::cosim
