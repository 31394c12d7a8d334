/// When a port of the bench holds back: random, and the same for the same seed.
#ifndef FLOORLINE_TB_COSIM_STALLS_H
#define FLOORLINE_TB_COSIM_STALLS_H

#include <cstdint>

namespace floorline::cosim {

enum class Stalls {
  none,   ///< Never.
  light,  ///< One cycle in sixteen.
  heavy   ///< Phases of up to 256 cycles, one in eight of up to 1024, with none, half, or nearly all of them
          ///< stalled, so that buffers run empty and full.
};

inline const char* name(Stalls stalls) {
  return stalls == Stalls::none ? "none" : stalls == Stalls::light ? "light" : "heavy";
}

class StallPattern {
 public:
  StallPattern(Stalls level, std::uint64_t seed) : level_(level), state_(seed * 0x9e3779b97f4a7c15 + 1) {}

  /// Whether to hold back in this cycle; to be asked once a cycle.
  bool stall() {
    if (level_ == Stalls::none) return false;
    if (level_ == Stalls::light) return next() % 16 == 0;
    if (phase_ == 0) {
      constexpr std::uint32_t kSixteenths[] = {0, 8, 15};
      density_ = kSixteenths[next() % 3];
      phase_ = (1 + next() % 256) * (next() % 8 == 0 ? 4 : 1);
    }
    --phase_;
    return next() % 16 < density_;
  }

 private:
  /// xorshift64; the upper bits.
  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::uint32_t>(state_ >> 32);
  }

  Stalls level_;
  std::uint64_t state_;
  std::uint32_t phase_ = 0;
  std::uint32_t density_ = 0;
};

}  // namespace floorline::cosim

#endif
