/// What stands on the ports, cycle by cycle, around an element: the waves of a difference, for a picture.
#ifndef FLOORLINE_TB_COSIM_PORT_WATCH_H
#define FLOORLINE_TB_COSIM_PORT_WATCH_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "host/packing.h"

namespace floorline::cosim {

/// Streams of the top: video in, results out, taps.
enum class Port { video, points, obstacles, counts, difference, motion, blurred, region };
constexpr std::array<const char*, 8> kPortNames = {"video",      "points", "obstacles", "counts",
                                                   "difference", "motion", "blurred",   "region"};

constexpr std::size_t index(Port port) { return static_cast<std::size_t>(port); }

/// The taps are the last of them, in the order of the pipeline.
constexpr std::size_t kTapCount = kPortNames.size() - index(Port::difference);
constexpr Port tap_port(std::size_t tap) { return static_cast<Port>(index(Port::difference) + tap); }

/// A port when the clock rises: TVALID, TREADY, TDATA.
struct PortState {
  bool valid, ready;
  PackedElement data;

  bool moves() const { return valid && ready; }
};

struct PortCycle {
  std::uint64_t cycle;
  std::array<PortState, kPortNames.size()> ports;
};

/// Keeps the cycles before, in and after the one in which an element passes its port; those before the end
/// of the simulation when it never does.
class PortWatch {
 public:
  static constexpr std::size_t kBefore = 20, kAfter = 8;

  /// element: its number on the port, counted from the reset.
  PortWatch(Port port, std::uint64_t element) : port_(port), to_pass_(element + 1) {}

  void see(const PortCycle& cycle);

  Port port() const { return port_; }
  /// In order; at most kBefore + 1 + kAfter.
  const std::deque<PortCycle>& cycles() const { return cycles_; }
  /// Whether the element passed; it did in cycles()[passed_at()].
  bool passed() const { return to_pass_ == 0; }
  std::size_t passed_at() const { return cycles_.size() - 1 - after_; }

 private:
  Port port_;
  std::uint64_t to_pass_;
  std::size_t after_ = 0;  ///< Cycles kept since it passed.
  std::deque<PortCycle> cycles_;
};

}  // namespace floorline::cosim

#endif
