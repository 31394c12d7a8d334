#include "golden/polar.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "golden/displacement.h"
#include "test_image.h"

namespace floorline::golden {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const cv::Size size(40, 60);
const Line vertical = {{20, 0}, {20, 59}};

const cv::Mat unknown(size, CV_8UC1, cv::Scalar(unknown_motion));

Masks empty_masks() { return {cv::Mat::zeros(size, CV_8UC1), cv::Mat::zeros(size, CV_8UC1)}; }

/// A block that is set in both masks, columns 18 to 22.
void set_rows(Masks& masks, int first, int last) {
  for (cv::Mat& mask : {std::ref(masks.high), std::ref(masks.low)})
    mask(cv::Rect(18, first, 5, last - first + 1)) = 255;
}

const RuleParameters run_rule = {.kind = Rule::run, .min_rows = 12, .max_gap = 3};
const RuleParameters paper_rule = {.kind = Rule::paper};

TEST(Walk, VisitsThePixelsOfLineIteratorRowByRow) {
  for (const Line& line :
       {Line{{3, 2}, {35, 9}}, Line{{35, 2}, {3, 9}}, Line{{10, 0}, {13, 50}}, Line{{7, 5}, {30, 5}},
        Line{{30, 5}, {7, 5}}, Line{{-20, 1}, {60, 40}}, Line{{4, 4}, {4, 4}}}) {
    std::vector<cv::Point> walked;
    for (const Step& step : walk(line)) {
      const int direction = step.last_column < step.first_column ? -1 : 1;
      for (int u = step.first_column; u != step.last_column + direction; u += direction)
        walked.emplace_back(u, step.row);
    }
    std::vector<cv::Point> expected;
    cv::LineIterator pixel(line.first, line.last);
    for (int i = 0; i < pixel.count; ++i, ++pixel) expected.push_back(pixel.pos());
    EXPECT_EQ(walked, expected);
  }
}

TEST(Polar, CountsHighPixelsOnEachLine) {
  const Masks masks = {random_mask(size, 40, 3), random_mask(size, 80, 4)};
  const std::vector<Line> lines = {
      vertical, {{0, 0}, {39, 59}}, {{39, 10}, {0, 20}}, {{-30, 0}, {70, 30}}, {{5, 7}, {30, 7}}};
  const PolarHistogram histogram = polar(masks, unknown, lines, run_rule);
  ASSERT_EQ(histogram.counts.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    cv::LineIterator pixel(lines[i].first, lines[i].last);
    int expected = 0;
    for (int k = 0; k < pixel.count; ++k, ++pixel) {
      const bool inside = cv::Rect({0, 0}, size).contains(pixel.pos());
      expected += inside && masks.high.at<uchar>(pixel.pos()) != 0;
    }
    EXPECT_EQ(histogram.counts[i], expected) << "line " << i;
  }
}

TEST(Polar, RowsBelowTheImageDoNotExist) {
  Masks masks = empty_masks();
  set_rows(masks, 40, 59);
  const PolarHistogram histogram = polar(masks, unknown, {{{20, 0}, {20, 90}}}, run_rule);
  EXPECT_EQ(histogram.counts[0], 20);
  EXPECT_THAT(histogram.contacts, ElementsAre(Contact{0, 20, 59, 20, true}));
  EXPECT_EQ(polar(masks, unknown, {{{20, 70}, {20, 90}}}, run_rule).counts[0], 0);
}

TEST(RunRule, ARunIsAContactAtItsLastRow) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 29);
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 29, 20, false}));
}

/// Motion of an obstacle whose rows 10 to 29 are a run: it moves down to row 22, from there on it rests.
cv::Mat motion_of_an_obstacle() {
  cv::Mat motion(size, CV_8UC1, cv::Scalar(rests));
  motion.rowRange(10, 23) = moves;
  return motion;
}

TEST(RunRule, AFootRestsAndHasNotMovedForSevenRows) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 29);
  cv::Mat motion = motion_of_an_obstacle();
  const auto contacts = [&](const Line& line) { return polar(masks, motion, {line}, run_rule).contacts; };
  EXPECT_THAT(contacts(vertical), ElementsAre(Contact{0, 20, 29, 20, false}));
  motion.at<uchar>(28, 20) = stirs;
  EXPECT_EQ(contacts(vertical).size(), 1u) << "above the last row a foot may stir";
  motion.at<uchar>(29, 20) = stirs;
  EXPECT_THAT(contacts(vertical), IsEmpty());
  motion = motion_of_an_obstacle();
  motion.at<uchar>(23, 20) = moves;
  EXPECT_THAT(contacts(vertical), IsEmpty());
  EXPECT_EQ(contacts({{20, 0}, {20, 59}, true}).size(), 1u) << "its foot is at the other end";
}

TEST(RunRule, WhatStandsStirsInSevenRows) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 29);
  cv::Mat motion(size, CV_8UC1, cv::Scalar(rests));
  motion.rowRange(12, 18) = stirs;
  EXPECT_THAT(polar(masks, motion, {vertical}, run_rule).contacts, IsEmpty()) << "flat on the floor";
  motion.at<uchar>(20, 20) = stirs;
  EXPECT_EQ(polar(masks, motion, {vertical}, run_rule).contacts.size(), 1u);
}

TEST(RunRule, ARunThatGoesOnBelowTheImageMayMove) {
  Masks masks = empty_masks();
  set_rows(masks, 40, 59);
  const cv::Mat motion(size, CV_8UC1, cv::Scalar(moves));
  EXPECT_THAT(polar(masks, motion, {vertical}, run_rule).contacts, ElementsAre(Contact{0, 20, 59, 20, true}));
}

TEST(RunRule, ContactFirstTakesTheFirstRow) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 29);
  EXPECT_THAT(polar(masks, unknown, {{{20, 0}, {20, 59}, true}}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 10, 20, false}));
}

TEST(RunRule, SurvivesGapsUpToTheMaximum) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 19);
  set_rows(masks, 23, 30);  // Rows 20 to 22 are empty: a gap of three.
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 30, 21, false}));
  masks = empty_masks();
  set_rows(masks, 10, 19);
  set_rows(masks, 24, 31);  // A gap of four ends the run, and both parts are too short.
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts, IsEmpty());
}

TEST(RunRule, NeedsAThirdOfItsRowsHigh) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 27);
  masks.high.rowRange(15, 28) = 0;  // 5 of 18 rows are high.
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts, IsEmpty());
  masks.high(cv::Rect(22, 15, 1, 1)) = 255;  // The sixth, two columns off.
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 27, 18, false}));
}

TEST(RunRule, NeedsTheHeightOfTheLeastObstacleThere) {
  RuleParameters rule = run_rule;
  rule.horizon_row = -60;
  rule.height_ratio = 0.25;  // At row 29: 89 * 0.25 = 22 rows.
  Masks masks = empty_masks();
  set_rows(masks, 9, 29);
  EXPECT_THAT(polar(masks, unknown, {vertical}, rule).contacts, IsEmpty());
  set_rows(masks, 8, 8);
  EXPECT_THAT(polar(masks, unknown, {vertical}, rule).contacts, ElementsAre(Contact{0, 20, 29, 22, false}));
}

TEST(RunRule, IsNotClippedWhenTheGapEndsWithTheLine) {
  Masks masks = empty_masks();
  set_rows(masks, 36, 55);
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 55, 20, false}))
      << "rows 56 to 59 are the fourth gap row";
  set_rows(masks, 56, 56);
  EXPECT_THAT(polar(masks, unknown, {vertical}, run_rule).contacts,
              ElementsAre(Contact{0, 20, 56, 21, true}));
}

TEST(PaperRule, ScoresATriangleThatNarrows) {
  Masks masks = empty_masks();
  for (int row = 10; row <= 20; ++row) {
    const int half = row <= 17 ? 1 : 0;
    masks.high(cv::Rect(20 - half, row, 2 * half + 1, 1)) = 255;
  }
  // a_r = 3 from row 10 to 17, then 1: S_c = 0 in row 10, 10 in row 20.
  EXPECT_THAT(polar(masks, unknown, {vertical}, paper_rule).contacts,
              ElementsAre(Contact{0, 20, 20, 10, false}));
}

TEST(PaperRule, StartsAnewWhereTheWidthGrows) {
  Masks masks = empty_masks();
  masks.high(cv::Rect(20, 10, 1, 6)) = 255;
  masks.high(cv::Rect(19, 16, 3, 5)) = 255;  // Five rows: S_c = 0 to 4.
  EXPECT_THAT(polar(masks, unknown, {vertical}, paper_rule).contacts, IsEmpty());
  masks.high(cv::Rect(19, 21, 3, 1)) = 255;
  EXPECT_THAT(polar(masks, unknown, {vertical}, paper_rule).contacts,
              ElementsAre(Contact{0, 20, 21, 5, false}));
}

TEST(PaperRule, IgnoresContactFirst) {
  Masks masks = empty_masks();
  set_rows(masks, 10, 29);
  EXPECT_THAT(polar(masks, unknown, {{{20, 0}, {20, 59}, true}}, paper_rule).contacts,
              ElementsAre(Contact{0, 20, 29, 19, false}));
}

TEST(Polar, WindowReadsNothingOutsideTheImage) {
  Masks masks = empty_masks();
  masks.high.colRange(0, 2) = 255;
  masks.low.colRange(0, 2) = 255;
  // Column -1 is a neighbour of set pixels but lies outside itself; column 0 is inside.
  EXPECT_THAT(polar(masks, unknown, {{{-1, 0}, {-1, 59}}}, run_rule).contacts, IsEmpty());
  EXPECT_THAT(polar(masks, unknown, {{{0, 0}, {0, 59}}}, run_rule).contacts,
              ElementsAre(Contact{0, 0, 59, 60, true}));
}

TEST(Polar, ContactsComeInTheOrderOfTheirDecision) {
  Masks masks = empty_masks();
  set_rows(masks, 20, 39);
  masks.high(cv::Rect(4, 5, 5, 20)) = 255;
  masks.low(cv::Rect(4, 5, 5, 20)) = 255;
  const std::vector<Contact> contacts =
      polar(masks, unknown, {vertical, {{21, 0}, {21, 59}}, {{6, 0}, {6, 59}}}, run_rule).contacts;
  EXPECT_THAT(contacts, ElementsAre(Contact{2, 6, 24, 20, false}, Contact{0, 20, 39, 20, false},
                                    Contact{1, 21, 39, 20, false}));
}

TEST(Polar, WithoutLinesThereIsNothing) {
  const PolarHistogram histogram = polar(empty_masks(), unknown, {}, run_rule);
  EXPECT_THAT(histogram.counts, IsEmpty());
  EXPECT_THAT(histogram.contacts, IsEmpty());
}

}  // namespace
}  // namespace floorline::golden
