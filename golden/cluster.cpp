#include "golden/cluster.h"

#include <cmath>
#include <map>

namespace floorline::golden {
namespace {

/// Lines back to which a point may join: 3 bridges one or two lines without a point.
constexpr int reach = 3;

double range(const FloorPoint& p) { return std::hypot(p.x, p.y); }

/// Of each line the point nearest to the robot, the first of equals.
std::map<int, FloorPoint> nearest_of_lines(const std::vector<FloorPoint>& points) {
  std::map<int, FloorPoint> nearest;
  for (const FloorPoint& point : points) {
    const auto [entry, is_new] = nearest.try_emplace(point.contact.line, point);
    if (!is_new && range(point) < range(entry->second)) entry->second = point;
  }
  return nearest;
}

struct Group {
  Obstacle obstacle;
  int lines = 1;
};

}  // namespace

std::vector<Obstacle> cluster(const std::vector<FloorPoint>& points, double gap_m, int min_lines) {
  const std::map<int, FloorPoint> nearest = nearest_of_lines(points);
  std::vector<Group> groups;
  std::map<int, int> group_of_line;
  const auto joined_group = [&](int line, const FloorPoint& point) {
    for (int before = line - 1; before >= line - reach; --before) {
      const auto neighbour = nearest.find(before);
      if (neighbour == nearest.end()) continue;
      const FloorPoint& other = neighbour->second;
      if (std::hypot(point.x - other.x, point.y - other.y) <= gap_m) return group_of_line.at(before);
    }
    return -1;
  };

  for (const auto& [line, point] : nearest) {
    const int joined = joined_group(line, point);
    if (joined < 0) {
      group_of_line[line] = static_cast<int>(groups.size());
      groups.push_back({{line, line, point}});
      continue;
    }
    group_of_line[line] = joined;
    Group& group = groups[joined];
    ++group.lines;
    group.obstacle.last_line = line;
    if (range(point) < range(group.obstacle.nearest)) group.obstacle.nearest = point;
  }

  std::vector<Obstacle> obstacles;
  for (const Group& group : groups) {
    if (group.lines >= min_lines) obstacles.push_back(group.obstacle);
  }
  return obstacles;
}

}  // namespace floorline::golden
