/// Cycles of a frame by its size, from the core's own counters, on frames back to back and without stalls.
#ifndef FLOORLINE_TB_COSIM_CYCLE_TABLE_H
#define FLOORLINE_TB_COSIM_CYCLE_TABLE_H

#include <cstdint>
#include <functional>
#include <opencv2/core/types.hpp>
#include <vector>

namespace floorline::cosim {

/// Registers of docs/registers.md, in cycles.
struct CycleRow {
  cv::Size size;
  std::uint32_t frame_cycles;
  std::uint32_t first_result_latency;
  std::uint32_t decision_latency;

  bool operator==(const CycleRow&) const = default;
};

/// From the least size to the greatest, odd ones too.
const std::vector<cv::Size>& measured_sizes();

/// The same for the same RTL: frames and parameters are fixed.
CycleRow measure_cycles(cv::Size size);

}  // namespace floorline::cosim

#endif
