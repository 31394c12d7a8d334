/// What leaves the core in a frame, bit by bit against the C simulation.
#ifndef FLOORLINE_TB_COSIM_COMPARISON_H
#define FLOORLINE_TB_COSIM_COMPARISON_H

#include <cstdint>
#include <string>
#include <vector>

#include "host/packing.h"
#include "tb/cosim/axi_stream.h"
#include "tb/csim/csim.h"

namespace floorline::cosim {

/// A frame's results as the core must send them: elements packed, each stream with the one that ends it.
struct ExpectedFrame {
  explicit ExpectedFrame(const FrameOutput& output);

  std::vector<PackedElement> points, obstacles, counts;
  std::uint32_t null_pixels;
  bool malformed = false;
};

/// Differing bits of a stream; an element that one side lacks counts as a whole, the mark of a malformed
/// frame as one bit. The first difference is put into words in `first`, unless it says something already.
long compare(const char* stream, const std::vector<PackedElement>& expected, bool malformed,
             const Packet& got, std::string& first);

}  // namespace floorline::cosim

#endif
