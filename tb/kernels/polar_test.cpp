#include "hls/polar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "golden/displacement.h"
#include "golden/polar.h"
#include "host/line_table.h"

namespace floorline {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kMaxWidth = 96;
constexpr int kMaxHeight = 64;
constexpr int kMaxLines = 64;

struct Histogram {
  std::vector<int> counts;
  std::vector<golden::Contact> contacts;
};

Motion packed(uchar motion) {
  return motion == golden::rests   ? RESTS
         : motion == golden::stirs ? STIRS
         : motion == golden::moves ? MOVES
                                   : UNKNOWN;
}

/// One frame through the kernel. Checks that the inputs are consumed and that both outputs end where they
/// must.
Histogram run(const golden::Masks& masks, const cv::Mat& motion, const std::vector<LineSetup>& table,
              const RuleParameters& rule) {
  hls::stream<Mask> mask("mask");
  hls::stream<Motion> motions("motions");
  hls::stream<Contact> contacts("contacts");
  hls::stream<LineCount> counts("counts");
  for (int v = 0; v < masks.high.rows; ++v) {
    for (int u = 0; u < masks.high.cols; ++u) {
      mask.write(2 * (masks.high.at<uchar>(v, u) != 0) + (masks.low.at<uchar>(v, u) != 0));
      motions.write(packed(motion.at<uchar>(v, u)));
    }
  }
  std::vector<LineSetup> lines = table;
  lines.resize(kMaxLines);
  polar<kMaxWidth, kMaxHeight, kMaxLines>(mask, motions, contacts, counts, masks.high.cols, masks.high.rows,
                                          table.size(), rule, lines.data());
  EXPECT_TRUE(mask.empty());
  EXPECT_TRUE(motions.empty());

  Histogram histogram;
  for (Contact c = contacts.read(); !c.end; c = contacts.read()) {
    histogram.contacts.push_back(
        {c.line.to_int(), c.u.to_int(), c.v.to_int(), c.rows.to_int(), c.clipped != 0});
  }
  EXPECT_TRUE(contacts.empty());
  bool end = false;
  while (!end) {
    const LineCount count = counts.read();
    EXPECT_EQ(count.line.to_int(), static_cast<int>(histogram.counts.size()));
    histogram.counts.push_back(count.count.to_int());
    end = count.end;
  }
  EXPECT_TRUE(counts.empty());
  return histogram;
}

/// Without known motion.
Histogram run(const golden::Masks& masks, const std::vector<LineSetup>& table, const RuleParameters& rule) {
  return run(masks, cv::Mat(masks.high.size(), CV_8UC1, cv::Scalar(golden::unknown_motion)), table, rule);
}

RuleParameters packed(const golden::RuleParameters& rule) {
  RuleParameters result;
  result.run_rule = rule.kind == golden::Rule::run;
  result.min_rows = rule.min_rows;
  result.max_gap = rule.max_gap;
  result.horizon_row = static_cast<int>(rule.horizon_row);
  result.height_ratio = static_cast<int>(256 * rule.height_ratio);
  result.min_lines = 2;
  return result;
}

std::vector<golden::Line> golden_lines(const std::vector<BeamLine>& lines) {
  std::vector<golden::Line> result;
  for (const BeamLine& line : lines) result.push_back({line.first, line.last, line.contact_first});
  return result;
}

/// Returns how many contacts there were to compare.
std::size_t expect_golden(const golden::Masks& masks, const cv::Mat& motion,
                          const std::vector<BeamLine>& lines, const golden::RuleParameters& rule) {
  const Histogram ours = run(masks, motion, line_table(lines, masks.high.size()), packed(rule));
  const golden::PolarHistogram expected = golden::polar(masks, motion, golden_lines(lines), rule);
  EXPECT_EQ(ours.counts, expected.counts);
  EXPECT_EQ(ours.contacts.size(), expected.contacts.size());
  for (std::size_t i = 0; i < std::min(ours.contacts.size(), expected.contacts.size()); ++i) {
    const golden::Contact &a = ours.contacts[i], &b = expected.contacts[i];
    EXPECT_EQ(a, b) << "contact " << i << ": line " << a.line << " (" << a.u << ", " << a.v << ") rows "
                    << a.rows << ", expected line " << b.line << " (" << b.u << ", " << b.v << ") rows "
                    << b.rows;
  }
  return expected.contacts.size();
}

golden::Masks empty_masks(cv::Size size) {
  return {cv::Mat::zeros(size, CV_8UC1), cv::Mat::zeros(size, CV_8UC1)};
}

golden::Masks full_masks(cv::Size size) {
  return {cv::Mat(size, CV_8UC1, cv::Scalar(255)), cv::Mat(size, CV_8UC1, cv::Scalar(255))};
}

/// A triangle that stands on its peak (column, peak_row): row peak_row - k is 2 * (k / 4) + 1 pixels wide.
golden::Masks triangle(cv::Size size, int column, int peak_row, int rows) {
  golden::Masks masks = empty_masks(size);
  for (int k = 0; k < rows; ++k) {
    const cv::Rect row(column - k / 4, peak_row - k, 2 * (k / 4) + 1, 1);
    masks.high(row) = 255;
    masks.low(row) = 255;
  }
  return masks;
}

const cv::Size kImage(80, 60);
const BeamLine kVertical = {{40, 0}, {40, 59}, false};
const golden::RuleParameters kPaper = {.kind = golden::Rule::paper};
const golden::RuleParameters kRun = {.kind = golden::Rule::run, .min_rows = 12, .max_gap = 3};

TEST(Polar, FindsThePeakOfATriangleByBothRules) {
  const golden::Masks masks = triangle(kImage, 40, 45, 24);
  const std::vector<LineSetup> lines = line_table({kVertical}, kImage);
  // a_high of the paper is 3, 3, ... 3 down to the four rows of one pixel: it never grows after the first
  // row.
  EXPECT_THAT(run(masks, lines, packed(kPaper)).contacts, ElementsAre(golden::Contact{0, 40, 45, 23, false}));
  EXPECT_THAT(run(masks, lines, packed(kRun)).contacts, ElementsAre(golden::Contact{0, 40, 45, 24, false}));
  EXPECT_THAT(run(masks, lines, packed(kRun)).counts, ElementsAre(24));
}

TEST(Polar, PaperRuleRefusesAWideningShape) {
  golden::Masks masks = triangle(kImage, 40, 45, 8);
  cv::flip(masks.high, masks.high, 0);
  EXPECT_THAT(run(masks, line_table({kVertical}, kImage), packed(kPaper)).contacts, IsEmpty());
}

TEST(Polar, AsksForAStandingBodyOnAStillFoot) {
  const golden::Masks masks = triangle(kImage, 40, 45, 24);  // Rows 22 to 45.
  const std::vector<LineSetup> lines = line_table({kVertical}, kImage);
  const auto contacts = [&](int last_moving, int last_stirring, const golden::RuleParameters& rule) {
    cv::Mat motion(kImage, CV_8UC1, cv::Scalar(golden::rests));
    motion.rowRange(0, last_stirring + 1) = golden::stirs;
    motion.rowRange(0, last_moving + 1) = golden::moves;
    return run(masks, motion, lines, packed(rule)).contacts.size();
  };
  EXPECT_EQ(contacts(38, 44, kRun), 1u);
  EXPECT_EQ(contacts(39, 44, kRun), 0u) << "six rows have not moved";
  EXPECT_EQ(contacts(38, 45, kRun), 0u) << "the last row stirs";
  EXPECT_EQ(contacts(-1, 28, kRun), 1u);
  EXPECT_EQ(contacts(-1, 27, kRun), 0u) << "six rows stir";
  EXPECT_EQ(contacts(45, 45, kPaper), 1u) << "the paper does not ask";
}

TEST(Polar, TakesTheFirstRowOfARunThatLeadsAwayFromTheNadir) {
  BeamLine away = kVertical;
  away.contact_first = true;
  const auto contacts = run(triangle(kImage, 40, 45, 24), line_table({away}, kImage), packed(kRun)).contacts;
  EXPECT_THAT(contacts, ElementsAre(golden::Contact{0, 40, 22, 24, false}));
}

TEST(Polar, MarksARunThatGoesOnBelowTheImage) {
  const auto contacts = run(full_masks(kImage), line_table({kVertical}, kImage), packed(kRun)).contacts;
  EXPECT_THAT(contacts, ElementsAre(golden::Contact{0, 40, 59, 60, true}));
}

TEST(Polar, AsksForTheHeightThatAnObstacleWouldHave) {
  // 24 rows, foot in row 45; the horizon in row 5 makes that 40 rows below it.
  const golden::Masks masks = triangle(kImage, 40, 45, 24);
  golden::RuleParameters rule = kRun;
  rule.horizon_row = 5;
  rule.height_ratio = 0.6;  // 153 / 256 of 40 rows: 23
  EXPECT_EQ(run(masks, line_table({kVertical}, kImage), packed(rule)).contacts.size(), 1u);
  rule.height_ratio = 0.63;  // 161 / 256 of 40 rows: 25
  EXPECT_THAT(run(masks, line_table({kVertical}, kImage), packed(rule)).contacts, IsEmpty());
}

TEST(Polar, CountsHorizontalVerticalAndSinglePixelLines) {
  const std::vector<BeamLine> lines = {{{0, 7}, {79, 7}, false},
                                       {{60, 9}, {20, 9}, false},
                                       kVertical,
                                       {{33, 33}, {33, 33}, false},
                                       {{0, 59}, {0, 59}, false}};
  EXPECT_THAT(run(full_masks(kImage), line_table(lines, kImage), packed(kRun)).counts,
              ElementsAre(80, 41, 60, 1, 1));
}

TEST(Polar, CountsOnlyColumnsInsideTheImage) {
  const std::vector<BeamLine> lines = {{{-30, 7}, {100, 7}, false}, {{-9, 0}, {-1, 59}, false},
                                       {{80, 0}, {300, 59}, false}, {{200, 7}, {-200, 7}, false},
                                       {{-120, 0}, {-1, 1}, false}, {{79, 0}, {300, 59}, false}};
  EXPECT_THAT(run(full_masks(kImage), line_table(lines, kImage), packed(kRun)).counts,
              ElementsAre(80, 0, 0, 80, 0, 1));
}

TEST(Polar, EndsLinesThatGoOnBelowTheImageInItsLastRow) {
  // The same table for a lower image: last rows beyond it, one line wholly below.
  const std::vector<BeamLine> lines = {kVertical, {{10, 50}, {10, 59}, false}};
  const auto histogram = run(full_masks({80, 40}), line_table(lines, kImage), packed(kRun));
  EXPECT_THAT(histogram.counts, ElementsAre(40, 0));
  EXPECT_THAT(histogram.contacts, ElementsAre(golden::Contact{0, 40, 39, 40, true}));
}

TEST(Polar, WithoutLinesSendsOneEmptyCount) {
  const auto histogram = run(full_masks(kImage), {}, packed(kRun));
  EXPECT_THAT(histogram.counts, ElementsAre(0));
  EXPECT_THAT(histogram.contacts, IsEmpty());
}

TEST(Polar, WalksNoMoreLinesThanARowHasRoomFor) {
  const std::vector<LineSetup> lines(20, line_setup({{8, 0}, {8, 59}, false}, {32, 60}));
  EXPECT_EQ(run(full_masks({32, 60}), lines, packed(kRun)).counts.size(), 16u);
}

TEST(Polar, ForgetsTheFrameBefore) {
  const std::vector<LineSetup> lines = line_table({kVertical}, kImage);
  run(full_masks(kImage), lines, packed(kRun));
  EXPECT_THAT(run(empty_masks(kImage), lines, packed(kRun)).counts, Each(0));
  EXPECT_THAT(run(empty_masks(kImage), lines, packed(kRun)).contacts, IsEmpty());
}

/// Random masks with runs of some length down the columns, so that rules have something to decide.
golden::Masks random_masks(cv::Size size, std::mt19937& random) {
  golden::Masks masks = empty_masks(size);
  std::uniform_int_distribution<int> column(0, size.width - 1), row(0, size.height - 1), extent(1, 25),
      percent(0, 99);
  for (int blob = 0; blob < 25; ++blob) {
    const cv::Rect area = cv::Rect(column(random), row(random), 1 + extent(random) / 6, extent(random)) &
                          cv::Rect(cv::Point(), size);
    masks.low(area) = 255;
    if (blob % 3) masks.high(area) = 255;
  }
  for (int noise = percent(random) * size.area() / 400; noise > 0; --noise) {
    (noise % 2 ? masks.high : masks.low).at<uchar>(row(random), column(random)) ^= 255;
  }
  return masks;
}

/// Motion of anything, in rows that mostly rest below and move above some row.
cv::Mat random_motion(cv::Size size, std::mt19937& random) {
  const uchar levels[] = {golden::rests, golden::unknown_motion, golden::stirs, golden::moves};
  std::uniform_int_distribution<int> row(0, size.height), any(0, 15);
  cv::Mat motion(size, CV_8UC1, cv::Scalar(golden::rests));
  motion.rowRange(0, row(random)) = golden::moves;
  for (uchar& level : cv::Mat_<uchar>(motion)) {
    const int choice = any(random);
    if (choice < 4) level = levels[choice];
  }
  return motion;
}

std::vector<BeamLine> random_lines(cv::Size size, std::mt19937& random) {
  std::uniform_int_distribution<int> column(-30, size.width + 30), row(0, size.height + 10), coin(0, 1);
  std::uniform_int_distribution<int> count(1, std::min(kMaxLines, size.width - 16));
  std::vector<BeamLine> lines;
  for (int i = count(random); i > 0; --i) {
    BeamLine line = {{column(random), row(random)}, {column(random), row(random)}, coin(random) == 1};
    if (line.first.y > line.last.y) std::swap(line.first, line.last);
    line.first.y = std::min(line.first.y, size.height - 1);
    lines.push_back(line);
  }
  return lines;
}

TEST(Polar, EqualsGoldenOnRandomMasksLinesAndRules) {
  std::mt19937 random(20);
  std::uniform_int_distribution<int> width(17, kMaxWidth), height(1, kMaxHeight), rows(1, 14), gap(0, 4),
      horizon(-40, 40), ratio(0, 200);
  std::size_t contacts[2] = {0, 0};
  for (int round = 0; round < 2000 && !testing::Test::HasFailure(); ++round) {
    const cv::Size size(width(random), height(random));
    golden::RuleParameters rule;
    rule.kind = round % 2 ? golden::Rule::run : golden::Rule::paper;
    rule.min_rows = rows(random);
    rule.max_gap = gap(random);
    rule.horizon_row = horizon(random);
    rule.height_ratio = ratio(random) / 256.0;
    SCOPED_TRACE(testing::Message() << "round " << round << ", size " << size);
    contacts[round % 2] += expect_golden(random_masks(size, random), random_motion(size, random),
                                         random_lines(size, random), rule);
  }
  EXPECT_GT(contacts[0], 100u) << "too few by the paper's rule";
  EXPECT_GT(contacts[1], 1000u) << "too few by the run rule";
}

}  // namespace
}  // namespace floorline
