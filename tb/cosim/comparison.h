/// What leaves the core in a frame, bit by bit against the C simulation.
#ifndef FLOORLINE_TB_COSIM_COMPARISON_H
#define FLOORLINE_TB_COSIM_COMPARISON_H

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/driver.h"
#include "host/packing.h"
#include "tb/cosim/axi_stream.h"
#include "tb/cosim/port_watch.h"
#include "tb/cosim/top.h"
#include "tb/csim/csim.h"

namespace floorline::cosim {

/// The registers that say something of the frame itself.
struct FrameStatus {
  std::uint32_t null_pixels, threshold_used;

  bool operator==(const FrameStatus&) const = default;
};

inline FrameStatus status(const HardwareCounters& counters) {
  return {counters.null_pixels, counters.threshold_used};
}

/// What the C simulation has for a frame, as the core must send it: elements packed, each stream with the one
/// that ends it; what passes on each tap (CV_8UC1).
struct ExpectedFrame {
  ExpectedFrame(CSimulation& csim, const cv::Mat& image, const FrameParameters& parameters,
                const std::vector<LineSetup>& lines);

  std::vector<PackedElement> points, obstacles, counts;
  std::array<cv::Mat, kTapCount> taps;
  FrameStatus status;
};

/// The first thing in which a frame differs.
struct Difference {
  std::string words;
  std::optional<Port> port;  ///< None: a register.
  std::uint64_t element;     ///< The port's, by its number; of elements that are missing, the one before.
};

/// Differing bits of a stream; an element that one side lacks counts as a whole, the mark of a malformed
/// frame as one bit. The first difference is told in `first`, unless there is one already; its elements are
/// those of the frame.
long compare(Port stream, const std::vector<PackedElement>& expected, bool malformed, const Packet& got,
             std::optional<Difference>& first);

/// The same for every tap. Takes the frame's elements out of `got`.
long compare_taps(const ExpectedFrame& expected, TapElements& got, std::optional<Difference>& first);

}  // namespace floorline::cosim

#endif
