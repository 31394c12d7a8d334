#include "tb/cosim/top.h"

#include <fmt/format.h>

#include "hls/accelerator.h"
#include "host/error.h"

namespace floorline::cosim {
namespace {

template <typename Config>
bool holds(cv::Size size) {
  return size.width <= Config::MAX_WIDTH && size.height <= Config::MAX_HEIGHT;
}

}  // namespace

Configuration configuration_for(cv::Size largest_frame) {
  if (holds<VgaConfig>(largest_frame)) return Configuration::vga;
  if (holds<WideConfig>(largest_frame)) return Configuration::wide;
  throw Error(fmt::format(
      "No configuration of the core holds frames of {}x{}; the greatest are 640x480 and 1280x384.",
      largest_frame.width, largest_frame.height));
}

Agents::Agents(Stalls stalls, std::uint64_t seed)
    : video(stalls, 8 * seed),
      points("m_axis_points", stalls, 8 * seed + 1),
      obstacles("m_axis_obstacles", stalls, 8 * seed + 2),
      counts("m_axis_counts", stalls, 8 * seed + 3),
      registers(stalls, 8 * seed + 4) {}

Top::Top(Configuration configuration, Stalls stalls, std::uint64_t seed)
    : model_(make_model(configuration, seed)), agents_(stalls, seed) {
  reset();
}

void Top::tick() {
  if (model_->tick(agents_, cycle_)) last_move_ = cycle_;
  ++cycle_;
}

void Top::run_until(const std::function<bool()>& done) {
  last_move_ = cycle_;
  while (!done()) {
    tick();
    if (cycle_ - last_move_ > kIdleLimit) {
      throw Hang(
          fmt::format("Nothing moved on any stream for {} cycles, up to cycle {}.", kIdleLimit, cycle_));
    }
  }
}

void Top::reset(int cycles) {
  agents_.video.reset();
  model_->set_reset(true);
  constexpr int kUnseen = 2;  // Registers of the core fall one cycle after the reset's own.
  for (int i = 0; i < kUnseen; ++i, ++cycle_) model_->tick_unseen();
  for (int i = 0; i < cycles; ++i) tick();
  for (PacketSink* sink : {&agents_.points, &agents_.obstacles, &agents_.counts}) sink->reset();
  for (std::vector<std::uint8_t>& elements : agents_.taps) elements.clear();
  model_->set_reset(false);
}

void Top::finish_access() {
  const std::uint64_t start = cycle_;
  while (agents_.registers.busy()) {
    tick();
    if (cycle_ - start > kIdleLimit) {
      throw Hang(
          fmt::format("A register access of cycle {} was not answered in {} cycles.", start, kIdleLimit));
    }
  }
}

std::uint32_t Top::try_read(std::uint32_t offset) {
  agents_.registers.begin_read(offset);
  finish_access();
  return agents_.registers.response();
}

std::uint32_t Top::try_write(std::uint32_t offset, std::uint32_t value, std::uint32_t strobe) {
  agents_.registers.begin_write(offset, value, strobe);
  finish_access();
  return agents_.registers.response();
}

std::uint32_t Top::read32(std::uint32_t offset) {
  if (try_read(offset) != 0) throw Error(fmt::format("The core refuses a read of register {:#x}.", offset));
  return agents_.registers.data();
}

void Top::write32(std::uint32_t offset, std::uint32_t value) {
  if (try_write(offset, value, 0xf) != 0)
    throw Error(fmt::format("The core refuses a write of register {:#x}.", offset));
}

}  // namespace floorline::cosim
