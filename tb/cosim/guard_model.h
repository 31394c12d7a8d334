/// What the frame guard makes of any video stream: the policy of rtl/frame_guard.v, beat by beat and without
/// time.
#ifndef FLOORLINE_TB_COSIM_GUARD_MODEL_H
#define FLOORLINE_TB_COSIM_GUARD_MODEL_H

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <utility>
#include <vector>

#include "tb/cosim/axi_stream.h"

namespace floorline::cosim {

class GuardModel {
 public:
  /// A frame that entered the core.
  struct Frame {
    cv::Size size;
    std::vector<std::uint32_t>
        pixels;  ///< As the core got them: size.area(), black where the guard filled up.
    bool malformed;
  };

  /// largest: of the core's LIMITS.
  explicit GuardModel(cv::Size largest) : largest_(largest) {}

  /// Taken at the next start of frame.
  void set_size(cv::Size size) { next_size_ = size; }
  /// ENABLE, with every beat so far through the guard.
  void set_enable(bool on);
  void take(const VideoBeat& beat);

  /// Frames that ended since the last call.
  std::vector<Frame> take_frames();
  std::uint32_t take_events() { return std::exchange(events_, 0); }  ///< Bits of FLOORLINE_INTERRUPT_STATUS.
  std::uint32_t started() const { return started_; }
  std::uint32_t malformed() const { return malformed_; }
  std::uint32_t dropped() const { return dropped_; }

 private:
  enum class State { wait, pass, skip_line };

  void start_or_drop(const VideoBeat& beat);
  void pass(const VideoBeat& beat);
  void fill(std::size_t pixels);
  void end_frame();

  cv::Size largest_, next_size_;
  bool enabled_ = false;
  State state_ = State::wait;
  bool stray_told_ = false;
  Frame frame_;
  std::vector<Frame> ended_;
  std::uint32_t events_ = 0, started_ = 0, malformed_ = 0, dropped_ = 0;
};

}  // namespace floorline::cosim

#endif
