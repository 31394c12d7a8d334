#include "tb/cosim/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <opencv2/core.hpp>

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

ExpectedFrame::ExpectedFrame(CSimulation& csim, const cv::Mat& image, const FrameParameters& parameters,
                             const std::vector<LineSetup>& lines) {
  StageCapture stages;
  const FrameOutput output = csim.run(image, parameters, lines, &stages);
  points = packet(output.points);
  obstacles = packet(output.obstacles);
  counts = packet(output.counts);
  taps = {stages.difference, stages.motion, stages.blurred, stages.region};
  status = {static_cast<std::uint32_t>(output.null_pixels),
            static_cast<std::uint32_t>(output.threshold_used)};
}

long compare(Port stream, const std::vector<PackedElement>& expected, bool malformed, const Packet& got,
             std::optional<Difference>& first) {
  const char* name = kPortNames[index(stream)];
  constexpr PackedElement kNone = {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff};
  long bits = malformed != got.malformed;
  for (std::size_t i = 0; i < std::max(expected.size(), got.elements.size()); ++i) {
    const PackedElement& want = i < expected.size() ? expected[i] : kNone;
    const PackedElement& is = i < got.elements.size() ? got.elements[i] : kNone;
    if (want == is) continue;
    for (std::size_t word = 0; word < want.size(); ++word) bits += std::popcount(want[word] ^ is[word]);
    if (!first) {
      first = {fmt::format("{}[{}] of {} is {}, the C simulation has {} (of {})", name, i,
                           got.elements.size(), hexadecimal(is), hexadecimal(want), expected.size()),
               stream, std::min(i, got.elements.size() - 1)};
    }
  }
  if (malformed != got.malformed && !first) {
    first = {fmt::format("{} are {}marked malformed", name, got.malformed ? "" : "not "), stream,
             got.elements.size() - 1};
  }
  return bits;
}

namespace {

long compare_tap(Port tap, const cv::Mat& expected, std::vector<std::uint8_t>& got,
                 std::optional<Difference>& first) {
  const char* name = kPortNames[index(tap)];
  constexpr long kElementBits = 8;
  const std::size_t count = expected.total(), compared = std::min(count, got.size());
  long bits = kElementBits * static_cast<long>(count - compared);
  if (bits != 0 && !first) {
    first = {fmt::format("tap {} has {} elements of {}", name, compared, count), tap,
             std::max<std::size_t>(compared, 1) - 1};
  }
  for (std::size_t i = 0; i < compared; ++i) {
    const std::uint8_t want = expected.data[i];
    if (got[i] == want) continue;
    bits += std::popcount(static_cast<std::uint8_t>(got[i] ^ want));
    if (!first) {
      first = {fmt::format("tap {} at column {}, row {} is {}, the C simulation has {}", name,
                           i % expected.cols, i / expected.cols, got[i], want),
               tap, i};
    }
  }
  got.erase(got.begin(), got.begin() + static_cast<std::ptrdiff_t>(compared));
  return bits;
}

}  // namespace

long compare_taps(const ExpectedFrame& expected, TapElements& got, std::optional<Difference>& first) {
  long bits = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    bits += compare_tap(tap_port(i), expected.taps[i], got[i], first);
  }
  return bits;
}

}  // namespace floorline::cosim
