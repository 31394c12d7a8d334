/// Runs the board demonstration in Verilator for some frames, decodes its serial line onto standard output
/// and checks it: the box of the test pattern must be reported where it touches the floor, and every frame
/// must end. Exit code 0: passed.
#include <verilated.h>

#include <cstdio>
#include <string>

#include "Vdemonstration.h"

namespace {

constexpr int kCyclesPerBit = 4;  // as the model is built
constexpr int kFrames = 3;        // the first one has no reference
constexpr long kLimit = 6L * 640 * 480;
constexpr unsigned kFoot = 480 / 3 + 480 / 4;

/// Collects bits of a line without parity, one sample a clock.
class SerialReader {
 public:
  /// True when a byte is complete; it is then in byte().
  bool sample(bool level) {
    if (cycle_ < 0) {
      if (level) return false;
      cycle_ = 0;
    }
    const int bit = cycle_ / kCyclesPerBit;  // 0 is the start bit
    if (cycle_ % kCyclesPerBit == kCyclesPerBit / 2 && bit >= 1 && bit <= 8)
      byte_ = static_cast<unsigned char>(byte_ >> 1 | (level ? 0x80 : 0));
    cycle_ = bit == 9 && cycle_ % kCyclesPerBit == kCyclesPerBit - 1 ? -1 : cycle_ + 1;
    return cycle_ == -1;
  }
  char byte() const { return static_cast<char>(byte_); }

 private:
  int cycle_ = -1;
  unsigned char byte_ = 0;
};

}  // namespace

int main() {
  Vdemonstration model;
  SerialReader serial;
  std::string line;
  int frames = 0, found = 0;
  for (long cycle = 0; cycle < kLimit && frames < kFrames; ++cycle) {
    model.rst = cycle < 4;
    model.clk = 0;
    model.eval();
    model.clk = 1;
    model.eval();
    if (cycle < 8 || !serial.sample(model.txd)) continue;
    if (serial.byte() == '\r') continue;
    if (serial.byte() != '\n') {
      line += serial.byte();
      continue;
    }
    std::puts(line.c_str());
    unsigned u = 0, v = 0;
    if (line == "-") ++frames;
    if (std::sscanf(line.c_str(), "%x %x", &u, &v) == 2 && v + 2 >= kFoot && v <= kFoot + 2) ++found;
    line.clear();
  }
  if (frames == kFrames && found > 0) return 0;
  std::fprintf(stderr, "error: %d of %d frames ended, %d contacts at the foot of the box\n", frames, kFrames,
               found);
  return 1;
}
