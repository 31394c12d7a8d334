#include "tb/cosim/cosimulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>

#include "rtl/floorline_registers.h"
#include "tb/cosim/comparison.h"
#include "tb/cosim/top.h"
#include "tb/cosim/video.h"
#include "tb/csim/csim.h"

namespace floorline::cosim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kFaultEvents =
    FLOORLINE_INTERRUPT_STATUS_EARLY_SOF_MASK | FLOORLINE_INTERRUPT_STATUS_LATE_SOF_MASK |
    FLOORLINE_INTERRUPT_STATUS_SHORT_LINE_MASK | FLOORLINE_INTERRUPT_STATUS_LONG_LINE_MASK |
    FLOORLINE_INTERRUPT_STATUS_DISABLED_IN_FRAME_MASK | FLOORLINE_INTERRUPT_STATUS_FRAME_DROPPED_MASK;

struct Waves {
  int frame;
  std::filesystem::path file;
};

class Session {
 public:
  Session(const Job& job, std::optional<Waves> waves)
      : job_(job),
        waves_(std::move(waves)),
        top_(configuration_for(job.largest_frame), job.stalls, job.seed),
        csim_(job.largest_frame),
        driver_(top_) {
    driver_.enable(true);
  }

  void run(int frame_count) {
    for (int i = 0; i < frame_count; ++i) {
      send(i);
      if (job_.progress) job_.progress(i);
    }
    receive();
    result_.cycles = top_.cycles();
    result_.seconds = seconds(start_) - csim_seconds_;
  }

  const Result& result() const { return result_; }

 private:
  static double seconds(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  }

  /// The last row is held back until the registers of the frame before have been read, so that they cannot be
  /// overwritten; frames of some size follow without a gap all the same.
  void send(int index) {
    const FrameInput input = prepared(job_.frame(index));
    top_.run_until([&] { return driver_.prepared_frame_started(); });
    if (waves_ && waves_->frame == index) top_.record(waves_->file);
    driver_.prepare(input.parameters, input.lines);
    queue_video(input.image, 0, input.image.rows - 1, top_.video().queue);
    if (index > 0) receive();
    queue_video(input.image, input.image.rows - 1, input.image.rows, top_.video().queue);
    expected_ = simulate(input);
  }

  static FrameInput prepared(FrameInput input) {
    input.parameters.width = input.image.cols;
    input.parameters.height = input.image.rows;
    input.parameters.grey = input.image.channels() == 1;
    return input;
  }

  ExpectedFrame simulate(const FrameInput& input) {
    const auto start = Clock::now();
    ExpectedFrame expected(csim_, input.image, input.parameters, input.lines);
    csim_seconds_ += seconds(start);
    return expected;
  }

  /// Waits for the results of the frame that was sent last but one row ago, and compares.
  void receive() {
    top_.run_until([&] {
      return !top_.points().packets.empty() && !top_.obstacles().packets.empty() &&
             !top_.counts().packets.empty();
    });
    FrameVerdict verdict;
    const auto take = [&](const char* name, const std::vector<PackedElement>& expected, PacketSink& sink) {
      const long bits = compare(name, expected, false, sink.packets.front(), verdict.first_difference);
      sink.packets.pop_front();
      return bits;
    };
    verdict.point_count = expected_->points.size() - 1;
    verdict.obstacle_count = expected_->obstacles.size() - 1;
    verdict.line_count = expected_->counts.size();
    for (const cv::Mat& tap : expected_->taps) verdict.tap_count += tap.total();
    verdict.taps = compare_taps(*expected_, top_.taps(), verdict.first_difference);
    verdict.points = take("points", expected_->points, top_.points());
    verdict.obstacles = take("obstacles", expected_->obstacles, top_.obstacles());
    verdict.counts = take("counts", expected_->counts, top_.counts());
    compare_registers(verdict);
    verdict.channels = top_.take_channels();
    result_.frames.push_back(verdict);
  }

  void compare_registers(FrameVerdict& verdict) {
    verdict.counters = driver_.counters();
    const std::uint32_t faults = driver_.take_events() & kFaultEvents;
    verdict.registers = std::popcount(verdict.counters.null_pixels ^ expected_->status.null_pixels) +
                        std::popcount(verdict.counters.threshold_used ^ expected_->status.threshold_used) +
                        std::popcount(verdict.counters.malformed_frames) +
                        std::popcount(verdict.counters.dropped_frames) + std::popcount(faults);
    if (verdict.registers && verdict.first_difference.empty()) {
      verdict.first_difference = fmt::format(
          "NULL_PIXELS is {}, the C simulation has {}; THRESHOLD_USED {} and {}; {} malformed and {} dropped "
          "frames, fault events {:#x}",
          verdict.counters.null_pixels, expected_->status.null_pixels, verdict.counters.threshold_used,
          expected_->status.threshold_used, verdict.counters.malformed_frames,
          verdict.counters.dropped_frames, faults);
    }
    const std::size_t frame = result_.frames.size();
    if (verdict.counters.frames == frame + 2) verdict.cycles = verdict.counters.frame_cycles;
  }

  const Job& job_;
  std::optional<Waves> waves_;
  Clock::time_point start_ = Clock::now();
  Top top_;
  CSimulation csim_;
  Driver driver_;
  std::optional<ExpectedFrame> expected_;
  Result result_;
  double csim_seconds_ = 0;
};

void save_waves(const Job& job, int frame) {
  if (job.waves.empty()) return;
  Session replay(job, Waves{frame, job.waves});
  try {
    replay.run(std::min(frame + 1, job.frame_count));
  } catch (const std::runtime_error&) {
    // The failure that is being recorded.
  }
}

int first_failure(const Result& result) {
  const auto fails = [](const FrameVerdict& verdict) { return verdict.differences() != 0; };
  return static_cast<int>(std::find_if(result.frames.begin(), result.frames.end(), fails) -
                          result.frames.begin());
}

}  // namespace

long Result::differences() const {
  long sum = 0;
  for (const FrameVerdict& frame : frames) sum += frame.differences();
  return sum;
}

Result cosimulate(const Job& job) {
  std::optional<Session> session(std::in_place, job, std::nullopt);
  const auto broken = [&] {
    const int frame = static_cast<int>(session->result().frames.size());
    session.reset();
    save_waves(job, frame);
  };
  try {
    session->run(job.frame_count);
  } catch (const ProtocolError&) {
    broken();
    throw;
  } catch (const Hang&) {
    broken();
    throw;
  }
  const Result result = session->result();
  if (result.differences() != 0) save_waves(job, first_failure(result));
  return result;
}

}  // namespace floorline::cosim
