#include "host/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "host/atomic_file.h"
#include "host/error.h"
#include "host/reference_plan.h"

namespace floorline {
namespace {

/// map_server's grey levels and the thresholds that tell them apart.
constexpr uchar occupied_grey = 0, free_grey = 254, unknown_grey = 205;
constexpr double occupied_threshold = 0.65, free_threshold = 0.196;

std::optional<Eigen::Vector2d> floor_at(const cv::Matx33d& floor_from_pixel, cv::Point pixel) {
  const cv::Vec3d floor = floor_from_pixel * cv::Vec3d(pixel.x, pixel.y, 1);
  if (!golden::denominator_resolved(floor[2])) return std::nullopt;
  return Eigen::Vector2d(floor[0] / floor[2], floor[1] / floor[2]);
}

Eigen::Isometry2d isometry2(const PlanarPose& pose) {
  return Eigen::Translation2d(pose.x_m, pose.y_m) * Eigen::Rotation2Dd(pose.yaw_rad);
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Parallax at a distance from the robot; parallax_px as PlannedFrame has it.
double parallax_at(double distance_m, double parallax_px) {
  return parallax_px * ReferenceRule().distance_m / std::max(distance_m, 0.1);
}

double probability(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

}  // namespace

std::vector<FloorRay> floor_rays(const golden::Parameters& parameters,
                                 const std::vector<golden::FloorPoint>& points) {
  std::vector<const golden::FloorPoint*> nearest(parameters.lines.size(), nullptr);
  for (const golden::FloorPoint& point : points) {
    const golden::FloorPoint*& best = nearest.at(point.contact.line);
    if (!best || std::hypot(point.x, point.y) < std::hypot(best->x, best->y)) best = &point;
  }
  std::vector<FloorRay> rays;
  for (std::size_t i = 0; i < parameters.lines.size(); ++i) {
    const golden::Line& line = parameters.lines[i];
    const auto near = floor_at(parameters.birdseye, line.contact_first ? line.first : line.last);
    const auto far = floor_at(parameters.birdseye, line.contact_first ? line.last : line.first);
    if (!near || !far) continue;
    FloorRay ray = {*near, *far, *far, false};
    if (const golden::FloorPoint* point = nearest[i]) {
      ray.hit = !point->contact.clipped;
      ray.free = ray.hit ? Eigen::Vector2d(point->x, point->y) : *near;
    }
    rays.push_back(ray);
  }
  return rays;
}

GridSettings grid_settings(double camera_height_m) {
  const double scale = camera_height_m / 0.6;
  GridSettings settings;
  settings.resolution_m *= scale;
  settings.range_m *= scale;
  settings.radius_m *= scale;
  settings.merge_m *= scale;
  return settings;
}

Grid::Grid(const GridSettings& settings) : settings_(settings) {}

void Grid::add(const PlanarPose& robot, const std::vector<FloorRay>& rays,
               const std::vector<Eigen::Vector2d>& obstacles, double parallax_px) {
  const View view = {isometry2(robot), rays, parallax_px};
  add_rays(view);
  add_reports(view, obstacles);
}

void Grid::add_rays(const View& view) {
  // Each cell is judged once a frame, however many rays cross it; an obstacle outweighs a ray that passes.
  std::map<Cell, double> judged;
  for (const FloorRay& ray : view.rays) {
    const Eigen::Vector2d along = ray.free - ray.near;
    const double length = along.norm();
    const double free_length = ray.hit ? length - settings_.resolution_m : length;
    for (double s = 0; s < free_length; s += settings_.resolution_m / 2) {
      const Eigen::Vector2d place = ray.near + along * (s / length);
      if (place.norm() > settings_.range_m) break;
      judged.try_emplace(cell_at(view.world_from_robot * place),
                         settings_.free_log_odds * absence_share(view, place.norm()));
    }
  }
  for (const FloorRay& ray : view.rays) {
    const double distance = ray.free.norm();
    if (ray.hit && distance <= settings_.range_m)
      judged[cell_at(view.world_from_robot * ray.free)] =
          settings_.hit_log_odds * report_share(view, distance);
  }
  for (const auto& [cell, evidence] : judged) log_odds_[cell] = limited(log_odds_[cell] + evidence);
}

void Grid::add_reports(const View& view, const std::vector<Eigen::Vector2d>& obstacles) {
  std::set<int> reported;
  for (const Eigen::Vector2d& obstacle : obstacles) {
    if (obstacle.norm() > settings_.range_m) continue;
    const Eigen::Vector2d place = view.world_from_robot * obstacle;
    const double evidence = settings_.report_log_odds * report_share(view, obstacle.norm());
    const auto distance = [&](const Candidate& c) { return (c.place - place).norm(); };
    const auto nearest = std::ranges::min_element(candidates_, {}, distance);
    if (nearest == candidates_.end() || distance(*nearest) > settings_.radius_m) {
      candidates_.push_back({next_id_, place, 1, evidence});
      reported.insert(next_id_++);
    } else if (reported.insert(nearest->id).second) {  // A second report in one frame is no second frame.
      ++nearest->reports;
      nearest->place +=
          (place - nearest->place) / std::min<double>(nearest->reports, settings_.settling_reports);
      nearest->log_odds = limited(nearest->log_odds + evidence);
    }
  }
  const Eigen::Isometry2d robot_from_world = view.world_from_robot.inverse();
  for (Candidate& candidate : candidates_) {
    const Eigen::Vector2d seen_from_robot = robot_from_world * candidate.place;
    if (reported.contains(candidate.id) || !in_view(view, seen_from_robot)) continue;
    candidate.log_odds += settings_.absence_log_odds * absence_share(view, seen_from_robot.norm());
  }
  std::erase_if(candidates_, [](const Candidate& candidate) { return candidate.log_odds < 0; });
}

bool Grid::in_view(const View& view, const Eigen::Vector2d& place) const {
  return place.norm() <= settings_.range_m && std::ranges::any_of(view.rays, [&](const FloorRay& ray) {
           return distance_to_segment(place, ray.near, ray.far) <= settings_.resolution_m;
         });
}

double Grid::report_share(const View& view, double distance_m) const {
  return std::min(1.0, parallax_at(distance_m, view.parallax_px) / settings_.report_parallax_px);
}

double Grid::absence_share(const View& view, double distance_m) const {
  return std::min(1.0, parallax_at(distance_m, view.parallax_px) / settings_.absence_parallax_px);
}

double Grid::limited(double log_odds) const {
  return std::clamp(log_odds, -settings_.limit_log_odds, settings_.limit_log_odds);
}

std::vector<ConfirmedObstacle> Grid::confirmed() const {
  std::vector<Candidate> surest;
  for (const Candidate& candidate : candidates_) {
    if (candidate.log_odds >= settings_.confirmed_log_odds) surest.push_back(candidate);
  }
  std::ranges::stable_sort(surest, std::greater(), &Candidate::log_odds);
  std::vector<ConfirmedObstacle> confirmed;
  for (const Candidate& candidate : surest) {
    const bool stands = std::ranges::none_of(confirmed, [&](const ConfirmedObstacle& surer) {
      return (surer.place - candidate.place).norm() < settings_.merge_m;
    });
    if (stands) confirmed.push_back({candidate.id, candidate.place, candidate.reports});
  }
  std::ranges::sort(confirmed, {}, &ConfirmedObstacle::id);
  return confirmed;
}

double Grid::occupancy(const Eigen::Vector2d& place) const {
  const auto entry = log_odds_.find(cell_at(place));
  return entry == log_odds_.end() ? 0.5 : probability(entry->second);
}

void Grid::write(const std::filesystem::path& folder) const {
  if (log_odds_.empty()) throw Error("The grid is empty: drive on until a frame has the wanted baseline.");
  Cell low = log_odds_.begin()->first;
  Cell high = low;
  for (const auto& [cell, value] : log_odds_) {
    low = {std::min(low.first, cell.first), std::min(low.second, cell.second)};
    high = {std::max(high.first, cell.first), std::max(high.second, cell.second)};
  }
  cv::Mat map(high.second - low.second + 1, high.first - low.first + 1, CV_8UC1, cv::Scalar(unknown_grey));
  for (const auto& [cell, value] : log_odds_) {
    uchar& grey = map.at<uchar>(high.second - cell.second, cell.first - low.first);
    if (probability(value) > occupied_threshold) grey = occupied_grey;
    if (probability(value) < free_threshold) grey = free_grey;
  }
  write_image(folder / "map.png", map);
  write_file(folder / "map.yaml",
             fmt::format("image: map.png\nresolution: {:g}\norigin: [{:.6g}, {:.6g}, 0.0]\nnegate: 0\n"
                         "occupied_thresh: {:g}\nfree_thresh: {:g}\n",
                         settings_.resolution_m, low.first * settings_.resolution_m,
                         low.second * settings_.resolution_m, occupied_threshold, free_threshold));
}

Grid::Cell Grid::cell_at(const Eigen::Vector2d& place) const {
  return {static_cast<int>(std::floor(place.x() / settings_.resolution_m)),
          static_cast<int>(std::floor(place.y() / settings_.resolution_m))};
}
}  // namespace floorline
