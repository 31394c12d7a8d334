/// AXI4-Stream agents: a source of video, and a sink of packets that checks the protocol.
///
/// Signals are decided before the clock edge from what is known after the one before, as registers would:
/// drive(), then the model settles, then sample().
#ifndef FLOORLINE_TB_COSIM_AXI_STREAM_H
#define FLOORLINE_TB_COSIM_AXI_STREAM_H

#include <cstdint>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/packing.h"
#include "tb/cosim/stalls.h"

namespace floorline::cosim {

/// A rule of AXI that a port of the core broke.
class ProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A pixel on the way in: TDATA, TUSER (start of frame), TLAST (end of line).
struct VideoBeat {
  std::uint32_t data;
  bool start_of_frame;
  bool end_of_line;
};

/// Offers the beats of a queue; VALID stays until READY.
class VideoSource {
 public:
  VideoSource(Stalls level, std::uint64_t seed) : stalls_(level, seed) {}

  std::deque<VideoBeat> queue;

  bool valid() const { return valid_; }
  const VideoBeat& beat() const { return queue.front(); }

  void drive() {
    const bool stalled = stalls_.stall();
    if (!valid_) valid_ = !queue.empty() && !stalled;
  }

  /// ready: TREADY at the clock edge. Whether a beat moved.
  bool sample(bool ready) {
    if (!valid_ || !ready) return false;
    queue.pop_front();
    valid_ = false;
    return true;
  }

  /// Forgets what was not sent; only with the core in reset may VALID fall.
  void reset() {
    queue.clear();
    valid_ = false;
  }

 private:
  StallPattern stalls_;
  bool valid_ = false;
};

/// An element on the way out.
struct ResultBeat {
  PackedElement data;
  bool user;
  bool last;

  bool operator==(const ResultBeat&) const = default;
};

/// The results of a frame on one stream, up to and including TLAST.
struct Packet {
  std::vector<PackedElement> elements;
  bool malformed = false;   ///< TUSER of the last element.
  std::uint64_t cycle = 0;  ///< When its last element was taken.
};

/// Takes packets. Checks that VALID stays and nothing changes until READY, that VALID is low in reset, and
/// that TUSER comes with TLAST only. Throws ProtocolError.
class PacketSink {
 public:
  PacketSink(std::string port, Stalls level, std::uint64_t seed)
      : port_(std::move(port)), stalls_(level, seed) {}

  std::deque<Packet> packets;

  void drive() { ready_ = !stalls_.stall(); }
  bool ready() const { return ready_; }
  /// Whether a beat was offered and not taken yet.
  bool waiting() const { return waiting_; }

  /// The core's side at the clock edge. Whether a beat moved.
  bool sample(bool valid, const ResultBeat& beat, bool in_reset, std::uint64_t cycle) {
    if (in_reset) {
      if (valid) fail("TVALID is high in reset", cycle);
      waiting_ = false;
      return false;
    }
    if (waiting_ && !valid) fail("TVALID fell before TREADY", cycle);
    if (waiting_ && !(beat == held_)) fail("the beat changed before TREADY", cycle);
    if (valid && beat.user && !beat.last) fail("TUSER without TLAST", cycle);
    waiting_ = valid && !ready_;
    if (waiting_) held_ = beat;
    if (!valid || !ready_) return false;
    open_.elements.push_back(beat.data);
    if (beat.last) {
      open_.malformed = beat.user;
      open_.cycle = cycle;
      packets.push_back(std::move(open_));
      open_ = {};
    }
    return true;
  }

  void reset() {
    packets.clear();
    open_ = {};
    waiting_ = false;
  }

 private:
  [[noreturn]] void fail(const char* what, std::uint64_t cycle) const {
    throw ProtocolError(port_ + ": " + what + ", cycle " + std::to_string(cycle) + ".");
  }

  std::string port_;
  StallPattern stalls_;
  bool ready_ = false;
  bool waiting_ = false;
  ResultBeat held_ = {};
  Packet open_;
};

}  // namespace floorline::cosim

#endif
