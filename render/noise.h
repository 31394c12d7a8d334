/// Numbers that look random and depend on their coordinates only, so that no thread order can change a
/// picture.
#ifndef FLOORLINE_RENDER_NOISE_H
#define FLOORLINE_RENDER_NOISE_H

#include <cmath>
#include <cstdint>

namespace floorline::render {

/// Mixes 64 bits well (the finaliser of the SplitMix64 generator).
inline std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// A stream of random numbers with its own seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

  std::uint64_t bits() { return mix(state_++); }
  /// Uniform in [low, high).
  double uniform(double low = 0.0, double high = 1.0) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1.0p-53;
  }
  bool chance(double probability) { return uniform() < probability; }
  int pick(int count) { return static_cast<int>(uniform(0, count)); }
  /// Standard normal: Box-Muller.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace floorline::render

#endif
