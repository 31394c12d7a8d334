#include "tb/cosim/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace floorline::cosim {
namespace {

template <typename Element>
std::vector<PackedElement> packet(const std::vector<Element>& elements) {
  std::vector<PackedElement> packed;
  for (const Element& element : elements) packed.push_back(pack(element));
  if (elements.empty() || !elements.back().end) {  // LineCount's last element is the end itself.
    Element end = {};
    end.end = 1;
    packed.push_back(pack(end));
  }
  return packed;
}

std::string hexadecimal(const PackedElement& e) {
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", e[3], e[2], e[1], e[0]);
}

}  // namespace

ExpectedFrame::ExpectedFrame(const FrameOutput& output)
    : points(packet(output.points)),
      obstacles(packet(output.obstacles)),
      counts(packet(output.counts)),
      null_pixels(static_cast<std::uint32_t>(output.null_pixels)) {}

long compare(const char* stream, const std::vector<PackedElement>& expected, bool malformed,
             const Packet& got, std::string& first) {
  constexpr PackedElement kNone = {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff};
  long bits = malformed != got.malformed;
  for (std::size_t i = 0; i < std::max(expected.size(), got.elements.size()); ++i) {
    const PackedElement& want = i < expected.size() ? expected[i] : kNone;
    const PackedElement& is = i < got.elements.size() ? got.elements[i] : kNone;
    if (want == is) continue;
    for (std::size_t word = 0; word < want.size(); ++word) bits += std::popcount(want[word] ^ is[word]);
    if (first.empty()) {
      first = fmt::format("{}[{}] of {} is {}, the C simulation has {} (of {})", stream, i,
                          got.elements.size(), hexadecimal(is), hexadecimal(want), expected.size());
    }
  }
  if (malformed != got.malformed && first.empty()) {
    first = fmt::format("{} are {}marked malformed", stream, got.malformed ? "" : "not ");
  }
  return bits;
}

}  // namespace floorline::cosim
