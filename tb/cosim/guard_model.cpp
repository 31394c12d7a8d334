#include "tb/cosim/guard_model.h"

#include "rtl/floorline_registers.h"

namespace floorline::cosim {
namespace {

constexpr int kLeastSide = 16;

}  // namespace

void GuardModel::set_enable(bool on) {
  enabled_ = on;
  if (on || state_ == State::wait) return;
  events_ |= FLOORLINE_INTERRUPT_STATUS_DISABLED_IN_FRAME_MASK;
  fill(frame_.size.area());
}

void GuardModel::take(const VideoBeat& beat) {
  if (beat.start_of_frame && state_ != State::wait) {
    events_ |= FLOORLINE_INTERRUPT_STATUS_EARLY_SOF_MASK;
    fill(frame_.size.area());
  }
  switch (state_) {
    case State::wait:
      start_or_drop(beat);
      break;
    case State::pass:
      pass(beat);
      break;
    case State::skip_line:
      if (beat.end_of_line) state_ = State::pass;
      break;
  }
}

void GuardModel::start_or_drop(const VideoBeat& beat) {
  const bool holds = next_size_.width >= kLeastSide && next_size_.height >= kLeastSide &&
                     next_size_.width <= largest_.width && next_size_.height <= largest_.height;
  if (beat.start_of_frame && enabled_ && holds) {
    ++started_;
    stray_told_ = false;
    frame_ = {next_size_, {}, false};
    state_ = State::pass;
    pass(beat);
    return;
  }
  if (beat.start_of_frame) {
    ++dropped_;
    events_ |= FLOORLINE_INTERRUPT_STATUS_FRAME_DROPPED_MASK;
  } else if (enabled_ && !stray_told_) {
    events_ |= FLOORLINE_INTERRUPT_STATUS_LATE_SOF_MASK;
  }
  stray_told_ = true;
}

void GuardModel::pass(const VideoBeat& beat) {
  frame_.pixels.push_back(beat.data);
  const std::size_t column = frame_.pixels.size() % frame_.size.width;  // 0: the line is complete
  if (column != 0 && beat.end_of_line) {
    events_ |= FLOORLINE_INTERRUPT_STATUS_SHORT_LINE_MASK;
    fill(frame_.pixels.size() + frame_.size.width - column);
  } else if (column == 0 && !beat.end_of_line) {
    events_ |= FLOORLINE_INTERRUPT_STATUS_LONG_LINE_MASK;
    frame_.malformed = true;
    state_ = State::skip_line;
  }
  if (static_cast<int>(frame_.pixels.size()) == frame_.size.area()) end_frame();
}

/// Black up to so many pixels.
void GuardModel::fill(std::size_t pixels) {
  frame_.pixels.resize(pixels, 0);
  frame_.malformed = true;
  if (static_cast<int>(pixels) == frame_.size.area()) end_frame();
}

void GuardModel::end_frame() {
  if (state_ == State::wait) return;
  state_ = State::wait;
  malformed_ += frame_.malformed;
  ended_.push_back(std::move(frame_));
  frame_ = {};
}

std::vector<GuardModel::Frame> GuardModel::take_frames() { return std::exchange(ended_, {}); }

}  // namespace floorline::cosim
