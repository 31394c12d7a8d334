#include "hls/cluster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "golden/cluster.h"

namespace floorline {
namespace {

constexpr int kMaxLines = 96;
constexpr double kGap = 0.25;

/// A point on the floor; the image coordinates just mark which one it is.
golden::FloorPoint point(int line, double x, double y, int mark = 0) {
  return {{line, mark, 200, 20, false}, x, y};
}

int fixed(double metres) { return static_cast<int>(metres * 65536); }

std::vector<golden::Obstacle> run(const std::vector<golden::FloorPoint>& frame, int lines, double gap,
                                  int min_lines) {
  hls::stream<FloorPoint> points("points");
  hls::stream<Obstacle> obstacles("obstacles");
  for (const golden::FloorPoint& p : frame) {
    const golden::Contact& c = p.contact;
    points.write({c.line, c.u, c.v, c.rows, fixed(p.x), fixed(p.y), c.clipped, 0});
  }
  points.write({0, 0, 0, 0, 0, 0, 0, 1});
  cluster<kMaxLines>(points, obstacles, lines, fixed(gap), min_lines);
  EXPECT_TRUE(points.empty());
  std::vector<golden::Obstacle> result;
  for (Obstacle o = obstacles.read(); !o.end; o = obstacles.read()) {
    result.push_back({o.first_line.to_int(),
                      o.last_line.to_int(),
                      {{0, o.u.to_int(), o.v.to_int(), o.rows.to_int(), o.clipped != 0},
                       o.x.to_double() / 65536,
                       o.y.to_double() / 65536}});
  }
  EXPECT_TRUE(obstacles.empty());
  return result;
}

/// First line, last line and mark of the nearest point.
std::vector<std::array<int, 3>> summary(const std::vector<golden::Obstacle>& obstacles) {
  std::vector<std::array<int, 3>> result;
  for (const golden::Obstacle& o : obstacles)
    result.push_back({o.first_line, o.last_line, o.nearest.contact.u});
  return result;
}

std::vector<std::array<int, 3>> clustered(const std::vector<golden::FloorPoint>& points, int min_lines = 2) {
  return summary(run(points, kMaxLines, kGap, min_lines));
}

using testing::ElementsAre;
using testing::IsEmpty;
using Report = std::array<int, 3>;

TEST(Cluster, ReportsAnObstacleOnceAtItsNearestPoint) {
  EXPECT_THAT(clustered({point(4, 2.0, 0.3, 1), point(5, 1.9, 0.1, 2), point(6, 2.0, -0.1, 3)}),
              ElementsAre(Report{4, 6, 2}));
}

TEST(Cluster, KeepsTheNearestPointOfALine) {
  EXPECT_THAT(clustered({point(4, 3.0, 0, 1), point(4, 2.0, 0, 2), point(4, 2.5, 0, 3), point(5, 2.1, 0, 4)}),
              ElementsAre(Report{4, 5, 2}));
}

TEST(Cluster, SeparatesWhatLiesFartherApartThanTheGap) {
  EXPECT_THAT(
      clustered({point(4, 2.5, 0.2, 3), point(5, 2.6, 0.2, 4), point(6, 2.0, 0, 1), point(7, 2.0, 0.2, 2)}),
      ElementsAre(Report{6, 7, 1}, Report{4, 5, 3}));
}

TEST(Cluster, JoinsAcrossAnyLinesBetween) {
  EXPECT_THAT(clustered({point(4, 2.0, 0, 1), point(30, 0.5, 0.1, 9), point(60, 2.0, 0.1, 2)}),
              ElementsAre(Report{4, 60, 1}));
}

TEST(Cluster, DoesNotGrowBeyondTheGapAroundItsNearestPoint) {
  EXPECT_THAT(clustered({point(4, 2.0, 0, 1), point(5, 2.2, 0, 2), point(6, 2.4, 0, 3)}, 1),
              ElementsAre(Report{4, 5, 1}, Report{6, 6, 3}));
}

TEST(Cluster, OfEquallyNearPointsTheFirstLineComesFirst) {
  EXPECT_THAT(clustered({point(9, 2.0, 1, 2), point(4, 2.0, -1, 1)}, 1),
              ElementsAre(Report{4, 4, 1}, Report{9, 9, 2}));
}

TEST(Cluster, DropsOrKeepsLoneLines) {
  EXPECT_THAT(clustered({point(4, 2.0, 0, 1)}), IsEmpty());
  EXPECT_THAT(clustered({point(4, 2.0, 0, 1)}, 1), ElementsAre(Report{4, 4, 1}));
  EXPECT_THAT(clustered({point(4, 2.0, 0, 1)}, 0), ElementsAre(Report{4, 4, 1})) << "0 counts as 1";
}

TEST(Cluster, TakesEveryLineAndTheFarthestPoints) {
  std::vector<golden::FloorPoint> points;
  for (int line = 0; line < kMaxLines; ++line)
    points.push_back(point(line, -128, line % 2 ? -128 : 127.99, line));
  EXPECT_THAT(clustered(points, 1), ElementsAre(Report{0, kMaxLines - 2, 0}, Report{1, kMaxLines - 1, 1}));
}

TEST(Cluster, ForgetsTheFrameBefore) {
  clustered({point(4, 2.0, 0, 1), point(5, 1.9, 0.1, 2)});
  EXPECT_THAT(clustered({}), IsEmpty());
  EXPECT_THAT(clustered({point(6, 2.0, 0, 1)}), IsEmpty()) << "must not join line 5 of the frame before";
}

TEST(Cluster, WithoutLinesReportsNothing) { EXPECT_THAT(run({}, 0, kGap, 1), IsEmpty()); }

TEST(Cluster, EqualsGoldenOnRandomPoints) {
  std::mt19937 random(31);
  std::uniform_int_distribution<int> lines(1, kMaxLines), place(-512, 1024), count(0, 120), min_lines(1, 3),
      gap(0, 600);
  int reports = 0;
  for (int round = 0; round < 500; ++round) {
    const int line_count = lines(random);
    std::vector<golden::FloorPoint> points;
    for (int i = count(random); i > 0; --i) {
      // On the grid of Q8.9, as the gap: nothing is cut down.
      points.push_back(point(random() % line_count, place(random) / 512.0, place(random) / 512.0, i));
    }
    const double gap_m = gap(random) / 512.0;
    const int least = min_lines(random);
    const auto ours = summary(run(points, line_count, gap_m, least));
    ASSERT_EQ(ours, summary(golden::cluster(points, gap_m, least))) << "round " << round;
    reports += static_cast<int>(ours.size());
  }
  EXPECT_GT(reports, 500);
}

}  // namespace
}  // namespace floorline
