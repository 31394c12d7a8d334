/// Broken streams and stray register accesses: the core must not hang, must mark and count what was wrong,
/// and the next good frame must come out right to the bit.
#ifndef FLOORLINE_TB_COSIM_FAULT_CAMPAIGN_H
#define FLOORLINE_TB_COSIM_FAULT_CAMPAIGN_H

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/driver.h"
#include "tb/cosim/comparison.h"
#include "tb/cosim/guard_model.h"
#include "tb/cosim/random_frames.h"
#include "tb/cosim/top.h"
#include "tb/csim/csim.h"

namespace floorline::cosim {

enum class Fault {
  early_start,   ///< A frame stops and the next one begins.
  late_start,    ///< Pixels before the start of a frame, or none marked as it.
  short_line,    ///< A line ends early.
  long_line,     ///< A line has pixels too many.
  missing_end,   ///< An end of line is missing.
  mutations,     ///< Several marks and pixels lost, doubled or turned over anywhere.
  refused_size,  ///< A frame of a size that the core does not hold.
  disabled,      ///< A frame while ENABLE is 0.
  disable_in_frame,
  reset_in_frame,
  register_accesses  ///< Reads and writes of any address with any strobe while frames pass.
};
constexpr int kFaultKinds = 11;

const char* name(Fault fault);

/// What was found; all but `injected` must be 0.
struct FaultTally {
  int injected = 0;
  int hung = 0;  ///< Injections after which something stood still.
  int wrong_frames =
      0;              ///< Frames with a bit that differs from the C simulation of what the guard let through.
  int uncounted = 0;  ///< Injections whose events or counters do not tell what happened.
  std::string first;  ///< The first of them in words.
};

/// Injects into frames of 16x16 to 48x32; every injection is followed by a good frame.
class FaultCampaign {
 public:
  FaultCampaign(Stalls stalls, std::uint64_t seed);

  /// One injection and a good frame. After a hang the core is reset.
  void inject(Fault fault);
  const FaultTally& tally() const { return tally_; }

 private:
  struct Prepared {
    FrameParameters parameters = {};
    std::vector<LineSetup> lines;
  };

  void disturb(Fault fault, std::deque<VideoBeat> beats);
  void mutate(Fault fault, std::deque<VideoBeat>& beats, int width);
  void access_registers();
  void prepare_frame();
  void queue(const std::deque<VideoBeat>& beats);
  void send(const std::deque<VideoBeat>& beats);
  void wait_for_starts();
  void let_pixels_through();
  void start_anew();
  FrameStatus check_frames();
  FrameStatus check_frame(const GuardModel::Frame& frame);
  void check_counters(FrameStatus expected);
  void tell(int& count, const std::string& what);

  RandomFrames random_;
  Top top_;
  // What a reset brings back to its start: core, driver and models are replaced together.
  std::optional<Driver> driver_;
  std::optional<GuardModel> guard_;
  std::optional<CSimulation> csim_;
  bool reference_lost_ = false;
  std::deque<Prepared> running_;  ///< Of the frames that started and were not checked yet.
  cv::Size size_;
  Prepared prepared_;
  FaultTally tally_;
  Fault fault_ = Fault::early_start;
};

}  // namespace floorline::cosim

#endif
