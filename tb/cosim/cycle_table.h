/// Cycles of a frame by its size and stalls, from the core's own counters, on frames back to back.
#ifndef FLOORLINE_TB_COSIM_CYCLE_TABLE_H
#define FLOORLINE_TB_COSIM_CYCLE_TABLE_H

#include <cstdint>
#include <functional>
#include <opencv2/core/types.hpp>
#include <vector>

#include "tb/cosim/stalls.h"
#include "tb/cosim/top.h"

namespace floorline::cosim {

/// Registers of docs/registers.md, in cycles, and what the stages took.
struct CycleRow {
  cv::Size size;
  Stalls stalls;
  std::uint32_t frame_cycles;
  std::uint32_t input_stalls;
  std::uint32_t output_stalls;
  std::uint32_t first_result_latency;
  std::uint32_t decision_latency;
  std::vector<StageRun> stages;  ///< Of one more frame, after all others have left.

  bool operator==(const CycleRow&) const = default;
};

/// What is measured.
struct CycleCase {
  cv::Size size;
  Stalls stalls;
};

/// From the least size to the greatest, odd ones too; some under stalls.
const std::vector<CycleCase>& cycle_cases();

/// The same for the same RTL: frames, parameters and stalls are fixed. Under stalls the lines end above the
/// last row, so that some contacts are told before the row that would decide them.
CycleRow measure_cycles(cv::Size size, Stalls stalls);

}  // namespace floorline::cosim

#endif
