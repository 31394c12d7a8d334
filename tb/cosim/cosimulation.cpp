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

/// A run up to a frame that failed, to see how.
struct Replay {
  int frame;
  std::filesystem::path waves;
  PortWatch* watch;  ///< None: the frame broke down before it could be compared.
};

class Session {
 public:
  Session(const Job& job, std::optional<Replay> replay)
      : job_(job),
        replay_(std::move(replay)),
        top_(configuration_for(job.largest_frame), job.stalls, job.seed),
        csim_(job.largest_frame),
        driver_(top_) {
    if (replay_ && replay_->watch != nullptr) top_.show(*replay_->watch);
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
    if (replay_ && replay_->frame == index) top_.record(replay_->waves);
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
    const auto take = [&](Port port, const std::vector<PackedElement>& expected, PacketSink& sink) {
      const long bits = compare(port, expected, false, sink.packets.front(), verdict.first_difference);
      sink.packets.pop_front();
      return bits;
    };
    verdict.point_count = expected_->points.size() - 1;
    verdict.obstacle_count = expected_->obstacles.size() - 1;
    verdict.line_count = expected_->counts.size();
    for (const cv::Mat& tap : expected_->taps) verdict.tap_count += tap.total();
    verdict.taps = compare_taps(*expected_, top_.taps(), verdict.first_difference);
    verdict.points = take(Port::points, expected_->points, top_.points());
    verdict.obstacles = take(Port::obstacles, expected_->obstacles, top_.obstacles());
    verdict.counts = take(Port::counts, expected_->counts, top_.counts());
    compare_registers(verdict);
    count_elements(verdict.first_difference);
    verdict.activity = top_.take_activity();
    result_.frames.push_back(verdict);
  }

  /// From the frame's element to the port's, and on to the next frame. Up to the first difference as many
  /// pass as are expected.
  void count_elements(std::optional<Difference>& first) {
    if (first && first->port) first->element += passed_[index(*first->port)];
    const auto pass = [&](Port port, std::size_t count) { passed_[index(port)] += count; };
    pass(Port::points, expected_->points.size());
    pass(Port::obstacles, expected_->obstacles.size());
    pass(Port::counts, expected_->counts.size());
    for (std::size_t i = 0; i < kTapCount; ++i) pass(tap_port(i), expected_->taps[i].total());
  }

  void compare_registers(FrameVerdict& verdict) {
    verdict.counters = driver_.counters();
    const std::uint32_t faults = driver_.take_events() & kFaultEvents;
    verdict.registers = std::popcount(verdict.counters.null_pixels ^ expected_->status.null_pixels) +
                        std::popcount(verdict.counters.threshold_used ^ expected_->status.threshold_used) +
                        std::popcount(verdict.counters.malformed_frames) +
                        std::popcount(verdict.counters.dropped_frames) + std::popcount(faults);
    if (verdict.registers && !verdict.first_difference) {
      const std::string words = fmt::format(
          "NULL_PIXELS is {}, the C simulation has {}; THRESHOLD_USED {} and {}; {} malformed and {} dropped "
          "frames, fault events {:#x}",
          verdict.counters.null_pixels, expected_->status.null_pixels, verdict.counters.threshold_used,
          expected_->status.threshold_used, verdict.counters.malformed_frames,
          verdict.counters.dropped_frames, faults);
      verdict.first_difference = {words, std::nullopt, 0};
    }
    const std::size_t frame = result_.frames.size();
    if (verdict.counters.frames == frame + 2) verdict.cycles = verdict.counters.frame_cycles;
  }

  const Job& job_;
  std::optional<Replay> replay_;
  Clock::time_point start_ = Clock::now();
  Top top_;
  CSimulation csim_;
  Driver driver_;
  std::optional<ExpectedFrame> expected_;
  std::array<std::uint64_t, kPortNames.size()> passed_ = {};  ///< Elements of the frames that were compared.
  Result result_;
  double csim_seconds_ = 0;
};

void replay(const Job& job, int frame, PortWatch* watch) {
  Session again(job, Replay{frame, job.waves, watch});
  try {
    again.run(std::min(frame + 1, job.frame_count));
  } catch (const std::runtime_error&) {
    // The failure that is being recorded.
  }
}

/// Runs up to the first frame that differs again.
void show_difference(const Job& job, Result& result) {
  const std::size_t frame = result.first_failure().value();
  const Difference& difference = result.frames[frame].first_difference.value();
  if (difference.port) result.watch.emplace(*difference.port, difference.element);
  replay(job, static_cast<int>(frame), result.watch ? &*result.watch : nullptr);
}

}  // namespace

long Result::differences() const {
  long sum = 0;
  for (const FrameVerdict& frame : frames) sum += frame.differences();
  return sum;
}

std::optional<std::size_t> Result::first_failure() const {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].differences() != 0) return i;
  }
  return {};
}

Result cosimulate(const Job& job) {
  std::optional<Session> session(std::in_place, job, std::nullopt);
  const auto broken = [&] {
    const int frame = static_cast<int>(session->result().frames.size());
    session.reset();
    if (!job.waves.empty()) replay(job, frame, nullptr);
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
  Result result = session->result();
  session.reset();
  if (result.first_failure() && !job.waves.empty()) show_difference(job, result);
  return result;
}

}  // namespace floorline::cosim
