/// Sequences through the RTL and the C simulation side by side: every bit that leaves the core is compared.
#ifndef FLOORLINE_TB_COSIM_COSIMULATION_H
#define FLOORLINE_TB_COSIM_COSIMULATION_H

#include <cstdint>
#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hls/parameters.h"
#include "hls/types.h"
#include "host/driver.h"
#include "tb/cosim/comparison.h"
#include "tb/cosim/port_watch.h"
#include "tb/cosim/stalls.h"
#include "tb/cosim/top.h"

namespace floorline::cosim {

/// What goes into the core for one frame. Width, height, grey and line_count of the parameters are set from
/// the rest.
struct FrameInput {
  cv::Mat image;  ///< CV_8UC1, or CV_8UC3 in OpenCV's order.
  FrameParameters parameters;
  std::vector<LineSetup> lines;
};

/// What came out, against the C simulation. Differences count bits; an element that one side lacks counts as
/// a whole.
struct FrameVerdict {
  long points = 0;
  long obstacles = 0;
  long counts = 0;
  long taps = 0;
  long registers =
      0;  ///< NULL_PIXELS, THRESHOLD_USED, MALFORMED_FRAMES, DROPPED_FRAMES and the fault events.
  std::optional<Difference> first_difference;  ///< Its element is counted from the first frame on.
  std::size_t point_count = 0;  ///< Elements that were compared, for a reader to see that there were some.
  std::size_t obstacle_count = 0;
  std::size_t line_count = 0;
  std::size_t tap_count = 0;
  HardwareCounters counters = {};  ///< Read when the frame's results had left.
  std::optional<std::uint32_t>
      cycles;         ///< FRAME_CYCLES of this frame; known when the next one started in time.
  Activity activity;  ///< From the results of the frame before to its own.

  long differences() const { return points + obstacles + counts + taps + registers; }
};

struct Job {
  cv::Size largest_frame;  ///< For the C simulation's configuration.
  int frame_count;
  std::function<FrameInput(int)>
      frame;  ///< Asked for in order; from 0 again when a failing frame is replayed.
  Stalls stalls;
  std::uint64_t seed;
  std::filesystem::path
      waves;  ///< Where the waves (FST) of the first failing frame go; empty: it is not run again.
  std::function<void(int)> progress;  ///< Called with the number of frames that are done.
};

struct Result {
  std::vector<FrameVerdict> frames;
  std::uint64_t cycles = 0;
  double seconds = 0;              ///< That the RTL took, without the C simulation.
  std::optional<PortWatch> watch;  ///< The ports around the first difference, if its frame was run again.

  long differences() const;
  std::optional<std::size_t> first_failure() const;  ///< The first frame that differs.
  double cycles_per_second() const { return static_cast<double>(cycles) / seconds; }
};

/// Frames back to back. A frame that differs, hangs or breaks the protocol is run again, with everything
/// before it, to save its waves. Rethrows ProtocolError and Hang after that.
Result cosimulate(const Job& job);

}  // namespace floorline::cosim

#endif
