#include "apps/wave_picture.h"

#include <gtest/gtest.h>

namespace floorline::app {
namespace {

using cosim::Port;

/// points offers 0xabcd from cycle 40 on, and it passes in cycle 42; blurred offers in cycle 41.
cosim::PortWatch watched() {
  cosim::PortWatch watch(Port::points, 0);
  for (std::uint64_t cycle = 0; cycle < 60; ++cycle) {
    cosim::PortCycle now = {cycle, {}};
    if (cycle >= 40 && cycle <= 42)
      now.ports[index(Port::points)] = {true, cycle == 42, {0x12abcd}};
    if (cycle == 41) now.ports[index(Port::blurred)] = {true, true, {0x7}};
    watch.see(now);
  }
  return watch;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(WavePicture, ShowsPortsThatOfferSomething) {
  const std::string picture = wave_picture(watched());
  EXPECT_EQ(picture.find("<svg"), 0u);
  for (const char* row : {"points tvalid", "points tready", "points tdata", "blurred tdata"})
    EXPECT_EQ(count(picture, row), 1u) << row;
  EXPECT_EQ(count(picture, "obstacles"), 0u);
}

TEST(WavePicture, ShowsWhatIsOffered) {
  const std::string picture = wave_picture(watched());
  EXPECT_EQ(count(picture, ">abcd<"), 3u) << "one cycle each, until it is taken";
  EXPECT_EQ(count(picture, ">0007<"), 1u);
  EXPECT_EQ(count(picture, ">22<"), 1u) << "the first cycle of the window";
}

TEST(WavePicture, ADifferingPortIsThereThoughItNeverOffers) {
  cosim::PortWatch watch(Port::counts, 0);
  watch.see({0, {}});
  EXPECT_EQ(count(wave_picture(watch), "counts tdata"), 1u);
}

}  // namespace
}  // namespace floorline::app
