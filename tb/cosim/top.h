/// rtl/floorline_top as a Verilator model with our agents on every port.
#ifndef FLOORLINE_TB_COSIM_TOP_H
#define FLOORLINE_TB_COSIM_TOP_H

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "host/driver.h"
#include "tb/cosim/axi_lite.h"
#include "tb/cosim/axi_stream.h"
#include "tb/cosim/stalls.h"

namespace floorline::cosim {

/// Nothing moved on any stream for so long that nothing will.
class Hang : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Everything that happens on a port happens in tick(): register accesses are calls that let cycles pass
/// until they are answered, while video and results go on.
class Top : public RegisterBus {
 public:
  /// Comes out of reset. `stalls` holds for every port; each has a sequence of its own from `seed`.
  Top(Stalls stalls, std::uint64_t seed);
  ~Top() override;
  Top(const Top&) = delete;
  Top& operator=(const Top&) = delete;

  /// One clock cycle. Throws ProtocolError, and Hang after kIdleLimit cycles in which pixels wait or results
  /// are awaited and nothing moves.
  void tick();
  /// Cycles until done() holds.
  void run_until(const std::function<bool()>& done);
  /// Some cycles with aresetn low. What is queued or half received is forgotten.
  void reset(int cycles = 4);

  VideoSource& video() { return video_; }
  PacketSink& points() { return points_; }
  PacketSink& obstacles() { return obstacles_; }
  PacketSink& counts() { return counts_; }
  bool interrupt() const;
  std::uint64_t cycles() const { return cycle_; }

  /// RegisterBus. Throws Error for an access that the core answers with SLVERR.
  std::uint32_t read32(std::uint32_t offset) override;
  void write32(std::uint32_t offset, std::uint32_t value) override;
  /// Any access; returns the response, 0 OKAY or 2 SLVERR.
  std::uint32_t try_read(std::uint32_t offset);
  std::uint32_t try_write(std::uint32_t offset, std::uint32_t value, std::uint32_t strobe);

  /// Waves (FST) of all signals from now on, until the Top goes.
  void record(const std::filesystem::path& file);

  static constexpr std::uint64_t kIdleLimit = 100'000;

 private:
  struct Model;

  void drive();
  void sample();
  void finish_access();

  std::unique_ptr<Model> model_;
  VideoSource video_;
  PacketSink points_, obstacles_, counts_;
  AxiLiteMaster registers_;
  std::uint64_t cycle_ = 0;
  std::uint64_t last_move_ = 0;
};

}  // namespace floorline::cosim

#endif
