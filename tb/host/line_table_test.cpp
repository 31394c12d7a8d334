#include "host/line_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>
#include <set>

#include "host/error.h"

namespace floorline {
namespace {

using testing::HasSubstr;
using testing::Throws;

const cv::Size kImage(64, 48);

struct PixelLess {
  bool operator()(cv::Point a, cv::Point b) const { return std::pair(a.y, a.x) < std::pair(b.y, b.x); }
};
using Pixels = std::set<cv::Point, PixelLess>;

Pixels walked(const LineSetup& line) {
  const auto pixels = line_pixels(line);
  return {pixels.begin(), pixels.end()};
}

Pixels iterated(cv::Point first, cv::Point last, int rows) {
  Pixels pixels;
  cv::LineIterator it(first, last, 8);
  for (int i = 0; i < it.count; ++i, ++it) {
    if (it.pos().y >= 0 && it.pos().y < rows) pixels.insert(it.pos());
  }
  return pixels;
}

TEST(LineSetup, WalksThePixelsOfLineIteratorInAllOctants) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> column(-40, 100), row(-30, 80);
  int checked = 0;
  while (checked < 20000) {
    cv::Point a(column(random), row(random)), b(column(random), row(random));
    if (a.y > b.y) std::swap(a, b);
    if (b.y < 0 || a.y >= kImage.height) continue;
    const LineSetup line = line_setup({a, b, false}, kImage);
    ASSERT_EQ(walked(line), iterated(a, b, kImage.height)) << a << " to " << b;
    ASSERT_EQ(walked(line).size(), line_pixels(line).size())
        << "a pixel was visited twice: " << a << " to " << b;
    ++checked;
  }
}

TEST(LineSetup, HoldsSinglePixelsHorizontalsAndVerticals) {
  for (const auto& [a, b] : std::vector<std::pair<cv::Point, cv::Point>>{
           {{5, 7}, {5, 7}}, {{3, 7}, {60, 7}}, {{60, 7}, {3, 7}}, {{5, 0}, {5, 47}}, {{0, 0}, {47, 47}}}) {
    EXPECT_EQ(walked(line_setup({a, b, false}, kImage)), iterated(a, b, kImage.height)) << a << " to " << b;
  }
}

TEST(LineSetup, RefusesWhatTheEngineCannotWalk) {
  EXPECT_THAT([] { line_setup({{3, 9}, {3, 8}, false}, kImage); }, Throws<Error>());
  EXPECT_THAT([] { line_setup({{3, -9}, {3, -1}, false}, kImage); }, Throws<Error>());
  EXPECT_THAT([] { line_setup({{3, 48}, {3, 60}, false}, kImage); }, Throws<Error>());
  EXPECT_THAT([] { line_setup({{-2048, 0}, {3, 60}, false}, kImage); }, Throws<Error>());
  EXPECT_THAT([] { line_setup({{0, -2000}, {3, 60}, false}, kImage); }, Throws<Error>());
}

LineBeam beam_with(Eigen::Vector3d focus, int lines = 24) { return {focus, kImage, 8, 47, lines}; }

TEST(BeamLines, SpreadAlongTheFirstRowTowardsANadirBelow) {
  const auto lines = beam_lines(beam_with({32, 200, 1}));
  ASSERT_EQ(lines.size(), 24u);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_FALSE(lines[i].contact_first);
    if (i > 0) EXPECT_GT(lines[i].last.x, lines[i - 1].last.x);
    // Each line points at the focus: its pixels stay within rounding of the ray.
    const cv::Point2d first = lines[i].first, last = lines[i].last;
    const double expected = first.x + (32.0 - first.x) / (200.0 - first.y) * (last.y - first.y);
    EXPECT_NEAR(last.x, expected, 1.0);
  }
  EXPECT_EQ(lines.front().last, cv::Point(0, 47)) << "the span must cover the lower corners";
  EXPECT_EQ(lines.back().last, cv::Point(63, 47));
}

TEST(BeamLines, AreParallelForALevelCamera) {
  const auto lines = beam_lines(beam_with({0, 500, 0}));
  for (const BeamLine& line : lines) {
    EXPECT_EQ(line.first.x, line.last.x);
    EXPECT_EQ(line.first.y, 8);
    EXPECT_EQ(line.last.y, 47);
  }
}

TEST(BeamLines, SurroundANadirInTheImage) {
  const auto lines = beam_lines(beam_with({30, 30, 1}));
  int away = 0;
  for (const BeamLine& line : lines) {
    away += line.contact_first;
    const bool starts_at_focus = line.first == cv::Point(30, 30);
    EXPECT_TRUE(starts_at_focus || line.last == cv::Point(30, 30));
    EXPECT_EQ(line.contact_first, starts_at_focus && line.last.y > 30);
  }
  EXPECT_EQ(away, 12);
}

TEST(BeamLines, NeverLeadAwayFromANadirThatIsAZenith) {
  for (const BeamLine& line : beam_lines(beam_with({-30, -30, -1}))) EXPECT_FALSE(line.contact_first);
}

TEST(BeamLines, StayInTheRoiWhereverTheFocusIs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-300, 300);
  for (int round = 0; round < 500; ++round) {
    const LineBeam beam = beam_with({place(random), place(random), round % 2 ? 1.0 : -1.0}, 1 + round % 40);
    for (const BeamLine& line : beam_lines(beam)) {
      for (const cv::Point end : {line.first, line.last}) {
        ASSERT_TRUE(cv::Rect(0, 8, 64, 40).contains(end)) << end << " for focus " << beam.focus.transpose();
      }
      ASSERT_NO_THROW(line_setup(line, kImage));
    }
  }
}

TEST(BeamLines, MayBeNone) { EXPECT_TRUE(beam_lines(beam_with({32, 200, 1}, 0)).empty()); }

std::string message_of(const LineBeam& beam) {
  try {
    beam_lines(beam);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(BeamLines, RefuseSetsThatCannotKeepUp) {
  EXPECT_EQ(message_of(beam_with({32, 200, 1}, 48)), "");
  EXPECT_THAT(message_of(beam_with({32, 200, 1}, 49)), HasSubstr("use at most 48 lines"));
  EXPECT_THAT(message_of(beam_with({32, 200, 1}, -1)), HasSubstr("0 to 256 lines"));
  EXPECT_THAT(message_of({{32, 200, 1}, {640, 480}, 0, 479, 257}), HasSubstr("0 to 256 lines"));
  EXPECT_THAT(message_of({{32, 200, 1}, kImage, 9, 8, 3}), HasSubstr("ROI rows"));
  EXPECT_THAT(message_of({{32, 200, 1}, kImage, 0, 48, 3}), HasSubstr("ROI rows"));
  EXPECT_THAT(message_of(beam_with({0, 0, 0})), HasSubstr("not a point"));
  EXPECT_THAT(message_of(beam_with({1, 0, 0})), HasSubstr("horizontal"));
  EXPECT_THAT(message_of(beam_with({std::nan(""), 0, 1})), HasSubstr("not a point"));
}

}  // namespace
}  // namespace floorline
