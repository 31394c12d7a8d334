/// rtl/floorline_top as a Verilator model with our agents on every port, in both configurations of the core.
#ifndef FLOORLINE_TB_COSIM_TOP_H
#define FLOORLINE_TB_COSIM_TOP_H

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <opencv2/core/types.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "host/driver.h"
#include "tb/cosim/axi_lite.h"
#include "tb/cosim/axi_stream.h"
#include "tb/cosim/port_watch.h"
#include "tb/cosim/stalls.h"

namespace floorline::cosim {

/// Nothing moved on any stream for so long that nothing will.
class Hang : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which core is in the top: hls/accelerator.h.
enum class Configuration {
  vga,  ///< 640x480, 256 lines.
  wide  ///< 1280x384, 256 lines.
};

/// The smallest one that holds frames of this size. Throws Error when none does.
Configuration configuration_for(cv::Size largest_frame);

/// Elements that passed on each tap and were not compared yet.
using TapElements = std::array<std::vector<std::uint8_t>, kTapCount>;

/// What is connected to the ports.
struct Agents {
  Agents(Stalls stalls, std::uint64_t seed);

  VideoSource video;
  PacketSink points, obstacles, counts;
  TapElements taps;
  AxiLiteMaster registers;
};

/// What a FIFO between two stages held, over some cycles.
struct ChannelCounts {
  const char* name;      ///< As in hls/accelerator.h.
  std::uint32_t depth;   ///< Words that it can hold.
  std::uint32_t most;    ///< Words that it held at most.
  std::uint64_t cycles;  ///< That were counted.
  std::uint64_t empty;   ///< Cycles in which its reader found nothing.
  std::uint64_t full;    ///< Cycles in which its writer found no room.
};

/// What a stage took, over some cycles.
struct StageRun {
  std::string_view name;  ///< As in hls/accelerator.h.
  std::uint32_t longest;  ///< Cycles from its start to its end in a frame, the longest of those that ended.

  bool operator==(const StageRun&) const = default;
};

/// Inside the core, since somebody asked last.
struct Activity {
  std::vector<ChannelCounts> channels;  ///< FIFOs between the stages in order.
  std::vector<StageRun> stages;         ///< In order.
};

/// The Verilator model of one configuration.
class TopModel {
 public:
  virtual ~TopModel() = default;

  /// One clock cycle: the agents decide, the logic settles, the agents see, the clock rises. Whether a beat
  /// moved on a stream. Throws ProtocolError.
  virtual bool tick(Agents& agents, std::uint64_t cycle) = 0;
  /// aresetn low and no VALID at the inputs, from the next cycle on, or the end of that.
  virtual void set_reset(bool on) = 0;
  /// One clock cycle that no agent sees.
  virtual void tick_unseen() = 0;
  virtual bool interrupt() const = 0;
  virtual void record(const std::filesystem::path& file) = 0;
  /// Shows every cycle's ports to `watch` from now on.
  virtual void show(PortWatch& watch) = 0;
  /// Since the last call; nothing for models that do not count.
  virtual Activity take_activity() { return {}; }
};

/// Of the library that is linked: cosim_models, or the seeded bugs of mutants.cpp. Registers without reset
/// start at random values from `seed`.
std::unique_ptr<TopModel> make_model(Configuration configuration, std::uint64_t seed);

/// Everything that happens on a port happens in tick(): register accesses are calls that let cycles pass
/// until they are answered, while video and results go on.
class Top : public RegisterBus {
 public:
  /// Comes out of reset. `stalls` holds for every port; each has a sequence of its own from `seed`.
  Top(Configuration configuration, Stalls stalls, std::uint64_t seed);

  /// One clock cycle. Throws ProtocolError, and Hang after kIdleLimit cycles in which pixels wait or results
  /// are awaited and nothing moves.
  void tick();
  /// Cycles until done() holds.
  void run_until(const std::function<bool()>& done);
  /// Some cycles with aresetn low. What is queued or half received is forgotten.
  void reset(int cycles = 4);

  VideoSource& video() { return agents_.video; }
  PacketSink& points() { return agents_.points; }
  PacketSink& obstacles() { return agents_.obstacles; }
  PacketSink& counts() { return agents_.counts; }
  TapElements& taps() { return agents_.taps; }
  bool interrupt() const { return model_->interrupt(); }
  std::uint64_t cycles() const { return cycle_; }

  /// Since the last call.
  Activity take_activity() { return model_->take_activity(); }

  /// RegisterBus. Throws Error for an access that the core answers with SLVERR.
  std::uint32_t read32(std::uint32_t offset) override;
  void write32(std::uint32_t offset, std::uint32_t value) override;
  /// Any access; returns the response, 0 OKAY or 2 SLVERR.
  std::uint32_t try_read(std::uint32_t offset);
  std::uint32_t try_write(std::uint32_t offset, std::uint32_t value, std::uint32_t strobe);

  /// Waves (FST) of all signals from now on, until the Top goes.
  void record(const std::filesystem::path& file) { model_->record(file); }
  /// Shows every cycle's ports to `watch` from now on.
  void show(PortWatch& watch) { model_->show(watch); }

  static constexpr std::uint64_t kIdleLimit = 100'000;

 private:
  void finish_access();

  std::unique_ptr<TopModel> model_;
  Agents agents_;
  std::uint64_t cycle_ = 0;
  std::uint64_t last_move_ = 0;
};

}  // namespace floorline::cosim

#endif
