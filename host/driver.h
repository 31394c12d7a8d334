/// Driver of the core: frame parameters, line table and status through its registers (docs/registers.md).
///
/// The same driver runs against the Verilator model (tb/cosim/top.h) and against a core on a board (UioBus).
/// Pixels and results move as AXI4-Streams; host/packing.h reads the elements of the results.
#ifndef FLOORLINE_HOST_DRIVER_H
#define FLOORLINE_HOST_DRIVER_H

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hls/parameters.h"
#include "hls/types.h"

namespace floorline {

/// 32-bit registers by byte offset.
class RegisterBus {
 public:
  virtual ~RegisterBus() = default;
  virtual std::uint32_t read32(std::uint32_t offset) = 0;
  virtual void write32(std::uint32_t offset, std::uint32_t value) = 0;
};

/// A core in memory, behind map 0 of a Linux UIO device.
class UioBus : public RegisterBus {
 public:
  /// device: for example /dev/uio0. Throws Error when it cannot be opened or mapped.
  explicit UioBus(const std::string& device);
  ~UioBus() override;
  UioBus(const UioBus&) = delete;
  UioBus& operator=(const UioBus&) = delete;

  std::uint32_t read32(std::uint32_t offset) override;
  void write32(std::uint32_t offset, std::uint32_t value) override;

 private:
  volatile std::uint32_t* registers_;
};

/// What the core counts itself; docs/registers.md says what each means. Cycles, pixels, frames.
struct HardwareCounters {
  std::uint32_t frames, malformed_frames, dropped_frames;
  std::uint32_t frame_cycles, input_stalls, output_stalls;
  std::uint32_t first_result_latency, decision_latency;
  std::uint32_t null_pixels;
  std::uint32_t threshold_used;  ///< Grey level.
};

class Driver {
 public:
  /// Reads ID, VERSION and LIMITS. Throws Error when another core, or another major version, answers.
  explicit Driver(RegisterBus& bus);

  cv::Size largest_frame() const { return largest_frame_; }
  std::size_t most_lines() const { return most_lines_; }

  /// Lets frames pass, or not; cleared in mid-frame, that frame becomes malformed.
  void enable(bool on);

  /// Whether a start of frame has taken what prepare() wrote last; before that, prepare() must not be called
  /// again.
  bool prepared_frame_started();

  /// Writes the parameters and lines that differ from those before, to be taken at the next start of frame.
  /// line_count of `parameters` is set from `lines`. Throws Error for a frame or a line table that the core
  /// cannot hold.
  void prepare(const FrameParameters& parameters, const std::vector<LineSetup>& lines);

  /// Events (bits of FLOORLINE_INTERRUPT_STATUS) since the last call, which clears them.
  std::uint32_t take_events();
  /// Events that raise the interrupt.
  void interrupt_on(std::uint32_t events);

  HardwareCounters counters();

 private:
  void write_lines(const std::vector<LineSetup>& lines);

  RegisterBus& bus_;
  cv::Size largest_frame_;
  std::size_t most_lines_;
  std::vector<std::uint32_t> written_;  ///< What the parameter registers hold; empty before the first frame.
  std::optional<std::vector<LineSetup>> lines_in_use_;
};

}  // namespace floorline

#endif
