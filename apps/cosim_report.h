/// What `floorline cosim` adds to a report (docs/report.md).
#ifndef FLOORLINE_APPS_COSIM_REPORT_H
#define FLOORLINE_APPS_COSIM_REPORT_H

#include <algorithm>
#include <filesystem>
#include <string>

#include "tb/cosim/cosimulation.h"

namespace floorline::app {

/// A run and what a person wants to know of it.
struct CosimSummary {
  cosim::Result result;
  cv::Size size;
  std::string stalls;

  std::size_t frames() const { return result.frames.size(); }
  long sum(long cosim::FrameVerdict::* stream) const {
    long total = 0;
    for (const cosim::FrameVerdict& frame : result.frames) total += frame.*stream;
    return total;
  }
  std::size_t sum(std::size_t cosim::FrameVerdict::* elements) const {
    std::size_t total = 0;
    for (const cosim::FrameVerdict& frame : result.frames) total += frame.*elements;
    return total;
  }
  std::uint32_t greatest(std::uint32_t HardwareCounters::* counter) const {
    std::uint32_t greatest = 0;
    for (const cosim::FrameVerdict& frame : result.frames)
      greatest = std::max(greatest, frame.counters.*counter);
    return greatest;
  }
  std::uint32_t most_cycles() const {
    std::uint32_t most = 0;
    for (const cosim::FrameVerdict& frame : result.frames) most = std::max(most, frame.cycles.value_or(0));
    return most;
  }
};

/// Writes the hardware sections to `file`, their pictures beside it: the comparison, cycles and latencies,
/// their histogram, and what the FIFOs between the stages held.
void write_hardware_sections(const CosimSummary& summary, const std::filesystem::path& file);

}  // namespace floorline::app

#endif
