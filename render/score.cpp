#include "score.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace floorline::render {
namespace {

using Eigen::Vector2d;

constexpr double marking_margin_m = 0.05;

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

double distance_to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

double distance_to(const Vector2d& p, const Polyline& line) {
  double least = (p - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

bool on_marking(const Vector2d& p, const Polyline& polygon) {
  bool inside = false;
  double edge = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    edge = std::min(edge, distance_to_segment(p, a, b));
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
    if (crosses && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside || edge < marking_margin_m;
}

double range_of(const std::vector<Polyline>& contact) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline& piece : contact) least = std::min(least, distance_to(Vector2d::Zero(), piece));
  return least;
}

bool is_due(const TrueObstacle& obstacle, const ScoreRules& rules) {
  return obstacle.height_m > rules.least_height_m && obstacle.contact_share >= rules.least_contact_share &&
         obstacle.visible_pixels >= rules.least_pixels && range_of(obstacle.contact) <= rules.range_m;
}

// Some foot in the scene: a piece of an obstacle's contact curve, or of a wall's (obstacle = null).
struct Foot {
  const TrueObstacle* obstacle;
  const Polyline* contact;
};

std::vector<Foot> feet_of(const TrueFrame& truth) {
  std::vector<Foot> feet;
  for (const TrueObstacle& obstacle : truth.obstacles) {
    for (const Polyline& piece : obstacle.contact) feet.push_back({&obstacle, &piece});
  }
  for (const Polyline& wall : truth.walls) feet.push_back({nullptr, &wall});
  return feet;
}

bool ahead_within(const Polyline& marking, double range) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& corner : marking) middle += corner / static_cast<double>(marking.size());
  return middle.x() > 0 && middle.norm() < range;
}

}  // namespace

double Score::recall() const { return ratio(found, due); }
double Score::precision() const { return ratio(right, right + wrong); }
double Score::duplicate_share() const { return ratio(duplicates, at_obstacles); }
double Score::marking_share() const { return ratio(marked, markings); }

double Score::median_error_m() const {
  if (errors_m.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> errors = errors_m;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

Score& Score::operator+=(const Score& other) {
  due += other.due;
  found += other.found;
  right += other.right;
  wrong += other.wrong;
  neutral += other.neutral;
  at_obstacles += other.at_obstacles;
  duplicates += other.duplicates;
  marked += other.marked;
  markings += other.markings;
  errors_m.insert(errors_m.end(), other.errors_m.begin(), other.errors_m.end());
  return *this;
}

Score score_reports(const std::vector<Vector2d>& reports, const TrueFrame& truth, const ScoreRules& rules) {
  const std::vector<Foot> feet = feet_of(truth);
  Score score;
  std::map<const Polyline*, int> reports_at;
  std::vector<const TrueObstacle*> found;
  std::vector<bool> marked(truth.markings.size(), false);
  for (const Vector2d& report : reports) {
    const double tolerance = std::max(rules.tolerance_m, rules.tolerance_share * report.norm());
    const auto distance = [&](const Foot& foot) { return distance_to(report, *foot.contact); };
    const auto nearest = std::min_element(
        feet.begin(), feet.end(), [&](const Foot& a, const Foot& b) { return distance(a) < distance(b); });
    const bool at_foot = nearest != feet.end() && distance(*nearest) <= tolerance;
    const bool low = at_foot && nearest->obstacle && nearest->obstacle->height_m <= rules.least_height_m;
    if (report.norm() > rules.range_m || low) {
      ++score.neutral;
    } else if (!at_foot) {
      ++score.wrong;
      for (std::size_t i = 0; i < marked.size(); ++i)
        marked[i] = marked[i] || on_marking(report, truth.markings[i]);
    } else {
      ++score.right;
      if (report.norm() <= rules.near_range_m) score.errors_m.push_back(distance(*nearest));
    }
    if (!at_foot) continue;
    for (const Foot& foot : feet) {
      if (foot.obstacle && distance(foot) <= tolerance) found.push_back(foot.obstacle);
    }
    if (nearest->obstacle && !low) {
      ++score.at_obstacles;
      score.duplicates += reports_at[nearest->contact]++ > 0;
    }
  }
  for (const TrueObstacle& obstacle : truth.obstacles) {
    if (!is_due(obstacle, rules)) continue;
    ++score.due;
    score.found += std::count(found.begin(), found.end(), &obstacle) > 0;
  }
  for (const Polyline& marking : truth.markings) score.markings += ahead_within(marking, rules.range_m);
  score.marked = static_cast<int>(std::count(marked.begin(), marked.end(), true));
  return score;
}

double PixelScore::precision() const {
  return ratio(static_cast<double>(hit), static_cast<double>(hit + false_alarm));
}
double PixelScore::recall() const {
  return ratio(static_cast<double>(hit), static_cast<double>(hit + missed));
}

PixelScore& PixelScore::operator+=(const PixelScore& other) {
  hit += other.hit;
  false_alarm += other.false_alarm;
  missed += other.missed;
  return *this;
}

PixelScore score_pixels(const cv::Mat& mask, const cv::Mat& truth_mask, int first_row) {
  PixelScore score;
  for (int row = std::max(0, first_row); row < mask.rows; ++row) {
    for (int column = 0; column < mask.cols; ++column) {
      const int truth = truth_mask.at<std::uint8_t>(row, column);
      if (truth == MaskValue::unknown) continue;
      const bool obstacle = truth == MaskValue::wall || truth >= MaskValue::first_obstacle;
      const bool reported = mask.at<std::uint8_t>(row, column) != 0;
      score.hit += obstacle && reported;
      score.false_alarm += !obstacle && reported;
      score.missed += obstacle && !reported;
    }
  }
  return score;
}

}  // namespace floorline::render
