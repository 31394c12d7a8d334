#include "tb/cosim/fault_campaign.h"

#include <fmt/format.h>

#include "rtl/floorline_registers.h"
#include "tb/cosim/video.h"

namespace floorline::cosim {
namespace {

const cv::Size kLargestFrame(48, 32);
/// Cycles in which the guard passes or fills up any frame, and every result leaves under heavy stalls.
constexpr int kSettlingCycles = 8 * 48 * 32 + 4096;

constexpr std::uint32_t kNotFaults = FLOORLINE_INTERRUPT_STATUS_FRAME_DONE_MASK;

cv::Mat image_of(const GuardModel::Frame& frame, bool grey) {
  cv::Mat image(frame.size, grey ? CV_8UC1 : CV_8UC3);
  for (int i = 0; i < frame.size.area(); ++i) {
    const std::uint32_t p = frame.pixels[i];
    if (grey) {
      image.data[i] = static_cast<uchar>(p);
    } else {
      image.at<cv::Vec3b>(i / frame.size.width, i % frame.size.width) =
          cv::Vec3b(static_cast<uchar>(p >> 8), static_cast<uchar>(p), static_cast<uchar>(p >> 16));
    }
  }
  return image;
}

}  // namespace

const char* name(Fault fault) {
  constexpr const char* kNames[kFaultKinds] = {
      "early start",  "late start", "short line",       "long line",      "missing end",      "mutations",
      "refused size", "disabled",   "disable in frame", "reset in frame", "register accesses"};
  return kNames[static_cast<int>(fault)];
}

FaultCampaign::FaultCampaign(Stalls stalls, std::uint64_t seed)
    : random_(seed), top_(Configuration::vga, stalls, seed) {
  start_anew();
}

/// After a reset: nothing is known of the frames before.
void FaultCampaign::start_anew() {
  driver_.emplace(top_);
  driver_->enable(true);
  guard_.emplace(driver_->largest_frame());
  guard_->set_enable(true);
  csim_.emplace(driver_->largest_frame());
  reference_lost_ = false;
  running_.clear();
}

void FaultCampaign::inject(Fault fault) {
  fault_ = fault;
  ++tally_.injected;
  try {
    prepare_frame();
    std::deque<VideoBeat> beats;
    queue_video(random_.image(size_), 0, size_.height, beats);
    disturb(fault, beats);
    if (random_.chance(0.5)) prepare_frame();
    beats.clear();
    queue_video(random_.image(size_), 0, size_.height, beats);
    send(beats);
    check_counters(check_frames());
  } catch (const std::runtime_error& error) {  // Hang, or a protocol that broke down.
    tell(tally_.hung, error.what());
    top_.reset();
    start_anew();
  }
}

void FaultCampaign::tell(int& count, const std::string& what) {
  ++count;
  if (tally_.first.empty()) {
    tally_.first =
        fmt::format("injection {} ({}), cycle {}: {}", tally_.injected, name(fault_), top_.cycles(), what);
  }
}

/// New parameters for the frames that start from now on.
void FaultCampaign::prepare_frame() {
  if (size_.empty() || random_.chance(0.5)) {
    size_ = random_.size(kLargestFrame);
    prepared_.lines = random_.lines(size_);
  }
  prepared_.parameters = random_.parameters(size_);
  prepared_.parameters.width = size_.width;
  prepared_.parameters.height = size_.height;
  prepared_.parameters.grey = random_.chance(0.5);
  driver_->prepare(prepared_.parameters, prepared_.lines);
  guard_->set_size(size_);
}

void FaultCampaign::queue(const std::deque<VideoBeat>& beats) {
  for (const VideoBeat& beat : beats) {
    top_.video().queue.push_back(beat);
    const std::uint32_t started = guard_->started();
    guard_->take(beat);
    if (guard_->started() != started) running_.push_back(prepared_);
  }
}

void FaultCampaign::send(const std::deque<VideoBeat>& beats) {
  queue(beats);
  wait_for_starts();
}

void FaultCampaign::wait_for_starts() {
  top_.run_until([&] { return top_.video().queue.empty(); });
  const std::uint64_t limit = top_.cycles() + kSettlingCycles;
  while (driver_->counters().frames != guard_->started() && top_.cycles() < limit) {
  }
}

/// Until what was sent has passed the guard.
void FaultCampaign::let_pixels_through() {
  for (int i = 0; i < kSettlingCycles; ++i) top_.tick();
}

void FaultCampaign::disturb(Fault fault, std::deque<VideoBeat> beats) {
  const auto cut = [&] { beats.resize(random_.number(1, static_cast<int>(beats.size()) - 1)); };
  switch (fault) {
    case Fault::refused_size: {
      constexpr int kTooSmall = 15;
      top_.write32(FLOORLINE_WIDTH, random_.chance(0.5) ? kTooSmall : driver_->largest_frame().width + 1);
      top_.write32(FLOORLINE_UPDATE, FLOORLINE_UPDATE_PARAMETERS_MASK);
      guard_->set_size({});
      send(beats);
      let_pixels_through();
      top_.write32(FLOORLINE_WIDTH, size_.width);
      top_.write32(FLOORLINE_UPDATE, FLOORLINE_UPDATE_PARAMETERS_MASK);
      guard_->set_size(size_);
      break;
    }
    case Fault::disabled:
    case Fault::disable_in_frame:
      if (fault == Fault::disable_in_frame) {
        cut();
        send(beats);
        let_pixels_through();
      }
      driver_->enable(false);
      guard_->set_enable(false);
      if (fault == Fault::disabled) send(beats);
      let_pixels_through();
      driver_->enable(true);
      guard_->set_enable(true);
      break;
    case Fault::reset_in_frame:
      cut();
      top_.video().queue = beats;
      // Often while the frame starts, which takes some dozen cycles.
      for (int i = random_.number(1, random_.chance(0.5) ? 64 : 2 * size_.area()); i > 0; --i) top_.tick();
      top_.reset();
      start_anew();
      prepare_frame();
      break;
    case Fault::register_accesses:
      queue(beats);
      top_.run_until([&] { return driver_->prepared_frame_started(); });
      access_registers();
      wait_for_starts();
      driver_.emplace(top_);  // It knows no longer what the registers hold.
      driver_->prepare(prepared_.parameters, prepared_.lines);
      break;
    default:
      mutate(fault, beats, size_.width);
      send(beats);
  }
}

void FaultCampaign::mutate(Fault fault, std::deque<VideoBeat>& beats, int width) {
  const auto anywhere = [&] { return beats.begin() + random_.number(0, static_cast<int>(beats.size()) - 1); };
  const auto end_of_a_line = [&] {
    return beats.begin() + width * random_.number(1, static_cast<int>(beats.size()) / width) - 1;
  };
  switch (fault) {
    case Fault::early_start:
      beats.resize(random_.number(1, static_cast<int>(beats.size()) - 1));
      break;
    case Fault::late_start:
      if (random_.chance(0.5)) {
        beats.front().start_of_frame = false;
      } else {
        beats.insert(beats.begin(), random_.number(1, 3 * width), {0xffffff, false, random_.chance(0.5)});
      }
      break;
    case Fault::short_line:
      beats.erase(end_of_a_line() - random_.number(1, width - 1));
      break;
    case Fault::long_line:
      beats.insert(end_of_a_line(), random_.number(1, 2 * width), {0x808080, false, false});
      break;
    case Fault::missing_end:
      end_of_a_line()->end_of_line = false;
      break;
    default:  // mutations
      for (int i = random_.number(1, 12); i > 0 && beats.size() > 1; --i) {
        const auto beat = anywhere();
        switch (random_.number(0, 3)) {
          case 0:
            beats.erase(beat);
            break;
          case 1:
            beats.insert(beat, *beat);
            break;
          case 2:
            beat->start_of_frame = !beat->start_of_frame;
            break;
          default:
            beat->end_of_line = !beat->end_of_line;
        }
      }
  }
}

/// Not written are the registers that act at once: those are faults of their own.
void FaultCampaign::access_registers() {
  constexpr int kWholeMap = 0x1fff;
  constexpr int kWholeWord = 0xf;
  for (int i = random_.number(1, 40); i > 0; --i) {
    const std::uint32_t offset = random_.number(0, kWholeMap);
    const std::uint32_t word = offset & ~3u;
    const bool acts =
        word == FLOORLINE_CONTROL || word == FLOORLINE_UPDATE || word == FLOORLINE_INTERRUPT_STATUS;
    const bool write = random_.chance(0.5) && !acts;
    const std::uint32_t strobe = random_.chance(0.7) ? kWholeWord : random_.number(0, kWholeWord);
    const std::uint32_t response =
        write ? top_.try_write(offset, random_.number(0, 0x7fffffff), strobe) : top_.try_read(offset);
    const bool bad = word != offset || (write && strobe != kWholeWord);
    if (bad && response == 0)
      tell(tally_.uncounted, fmt::format("access of {:#x} was answered with OKAY", offset));
  }
}

/// Every frame that entered the core; returns what the last one's registers must hold.
FrameStatus FaultCampaign::check_frames() {
  FrameStatus last = {};
  for (const GuardModel::Frame& frame : guard_->take_frames()) last = check_frame(frame);
  return last;
}

/// Broken frames hold what the guard made of them. A broken reference counts as none.
FrameStatus FaultCampaign::check_frame(const GuardModel::Frame& frame) {
  Prepared run = running_.front();
  running_.pop_front();
  if (reference_lost_) {
    ProjectiveMap& map = run.parameters.homography;
    map.zu = map.zv = map.z1 = 0;
  }
  if (run.parameters.replace_reference) reference_lost_ = frame.malformed;
  const ExpectedFrame expected(*csim_, image_of(frame, run.parameters.grey), run.parameters, run.lines);

  std::optional<Difference> first;
  long bits = 0;
  const auto take = [&](Port stream, const std::vector<PackedElement>& elements, PacketSink& sink) {
    top_.run_until([&] { return !sink.packets.empty(); });
    bits += compare(stream, elements, frame.malformed, sink.packets.front(), first);
    sink.packets.pop_front();
  };
  take(Port::points, expected.points, top_.points());
  take(Port::obstacles, expected.obstacles, top_.obstacles());
  take(Port::counts, expected.counts, top_.counts());
  bits += compare_taps(expected, top_.taps(), first);
  if (bits != 0) tell(tally_.wrong_frames, first->words);
  return expected.status;
}

void FaultCampaign::check_counters(FrameStatus expected) {
  const HardwareCounters counters = driver_->counters();
  const std::uint32_t events = driver_->take_events() & ~kNotFaults, expected_events = guard_->take_events();
  if (counters.frames == guard_->started() && counters.malformed_frames == guard_->malformed() &&
      counters.dropped_frames == guard_->dropped() && status(counters) == expected &&
      events == expected_events) {
    return;
  }
  tell(tally_.uncounted,
       fmt::format("{} frames, {} malformed, {} dropped, {} null pixels, threshold {}, events {:#x}; "
                   "must be {}, {}, {}, {}, {}, {:#x}",
                   counters.frames, counters.malformed_frames, counters.dropped_frames, counters.null_pixels,
                   counters.threshold_used, events, guard_->started(), guard_->malformed(), guard_->dropped(),
                   expected.null_pixels, expected.threshold_used, expected_events));
}

}  // namespace floorline::cosim
