#include "golden/cluster.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <map>

namespace floorline::golden {
namespace {

/// Obstacles that are looked at, the nearest ones.
constexpr int most_obstacles = 64;

double range(const FloorPoint& p) { return std::hypot(p.x, p.y); }

/// Of each line the point nearest to the robot, the first of equals; sorted by that distance, then by line.
std::list<FloorPoint> best_of_lines(const std::vector<FloorPoint>& points) {
  std::map<int, FloorPoint> best;
  for (const FloorPoint& point : points) {
    const auto [entry, is_new] = best.try_emplace(point.contact.line, point);
    if (!is_new && range(point) < range(entry->second)) entry->second = point;
  }
  std::list<FloorPoint> sorted;
  for (const auto& [line, point] : best) sorted.push_back(point);
  sorted.sort([](const FloorPoint& a, const FloorPoint& b) { return range(a) < range(b); });
  return sorted;
}

}  // namespace

std::vector<Obstacle> cluster(const std::vector<FloorPoint>& points, double gap_m, int min_lines) {
  std::list<FloorPoint> left = best_of_lines(points);
  std::vector<Obstacle> obstacles;
  for (int taken = 0; taken < most_obstacles && !left.empty(); ++taken) {
    const FloorPoint nearest = left.front();
    Obstacle obstacle = {nearest.contact.line, nearest.contact.line, nearest};
    const auto lines = left.remove_if([&](const FloorPoint& point) {
      if (std::max(std::abs(point.x - nearest.x), std::abs(point.y - nearest.y)) > gap_m) return false;
      obstacle.first_line = std::min(obstacle.first_line, point.contact.line);
      obstacle.last_line = std::max(obstacle.last_line, point.contact.line);
      return true;
    });
    if (static_cast<int>(lines) >= min_lines) obstacles.push_back(obstacle);
  }
  return obstacles;
}

}  // namespace floorline::golden
