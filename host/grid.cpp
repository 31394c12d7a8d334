#include "host/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "host/atomic_file.h"
#include "host/error.h"
#include "host/reference_plan.h"

namespace floorline {
namespace {

/// map_server's grey levels and the thresholds that tell them apart.
constexpr uchar occupied_grey = 0, free_grey = 254, unknown_grey = 205;
constexpr double occupied_threshold = 0.65, free_threshold = 0.196;

/// No body is looked at higher than this share of the camera's height: slides beyond are errors.
constexpr double steepest_slide = -0.6;
/// What a sighting weighs at least, however small its parallax.
constexpr double least_weight = 0.05;

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
  settings.steadying_m2 *= scale * scale;
  return settings;
}

SlidingPlace::SlidingPlace(double memory, double steadying_m2)
    : keep_(1 - 1 / memory), steadying_m2_(steadying_m2) {}

void SlidingPlace::add(const Eigen::Vector2d& place, const Eigen::Vector2d& robot, double weight) {
  weight_ = keep_ * weight_ + weight;
  const Eigen::Vector2d from_mean = robot - mean_robot_;
  mean_robot_ += weight / weight_ * from_mean;
  mean_place_ += weight / weight_ * (place - mean_place_);
  robot_square_ = keep_ * robot_square_ + weight * from_mean.dot(robot - mean_robot_);
  cross_product_ = keep_ * cross_product_ + weight * from_mean.dot(place - mean_place_);
}

double SlidingPlace::slide() const {
  return std::clamp(cross_product_ / (robot_square_ + steadying_m2_), steepest_slide, 0.0);
}

Eigen::Vector2d SlidingPlace::foot() const { return (mean_place_ - slide() * mean_robot_) / (1 - slide()); }

Eigen::Vector2d SlidingPlace::seen_from(const Eigen::Vector2d& robot) const {
  return mean_place_ + slide() * (robot - mean_robot_);
}

Grid::Grid(const GridSettings& settings) : settings_(settings) {}

void Grid::add(const PlanarPose& robot, const std::vector<FloorRay>& rays, double parallax_px) {
  const View view = {isometry2(robot), rays, parallax_px};
  add_rays(view);
  std::vector<End> line_ends = ends(view);
  see_again(view, line_ends);
  discover(view, line_ends);
  std::erase_if(candidates_, [](const Candidate& candidate) { return candidate.log_odds < 0; });
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

std::vector<Grid::End> Grid::ends(const View& view) const {
  std::vector<End> ends;
  for (const FloorRay& ray : view.rays) {
    if (ray.hit && ray.free.norm() <= settings_.range_m) ends.push_back({ray.free});
  }
  std::ranges::sort(ends, {}, [](const End& end) { return end.place.norm(); });
  return ends;
}

void Grid::see_again(const View& view, std::vector<End>& ends) {
  const Eigen::Isometry2d robot_from_world = view.world_from_robot.inverse();
  std::ranges::stable_sort(candidates_, std::greater(),
                           &Candidate::log_odds);  // The surest one chooses first.
  for (Candidate& candidate : candidates_) {
    const Eigen::Vector2d expected = robot_from_world * candidate.place.seen_from(view.robot());
    const End* nearest = nullptr;
    for (End& end : ends) {
      const double distance = (end.place - expected).norm();
      if (end.taken || distance > settings_.radius_m) continue;
      end.taken = true;
      if (!nearest || distance < (nearest->place - expected).norm()) nearest = &end;
    }
    if (nearest) {
      const double share = report_share(view, nearest->place.norm());
      ++candidate.reports;
      candidate.log_odds = limited(candidate.log_odds + settings_.report_log_odds * share);
      candidate.place.add(view.world_from_robot * nearest->place, view.robot(),
                          std::max(share, least_weight));
    } else if (proven_free(view, expected)) {
      candidate.log_odds += settings_.absence_log_odds * absence_share(view, expected.norm());
    }
  }
}

void Grid::discover(const View& view, std::vector<End>& ends) {
  for (const End& nearest : ends) {
    const Eigen::Vector2d place = nearest.place;
    if (nearest.taken || is_near_a_candidate(view, place)) continue;
    for (End& end : ends) end.taken = end.taken || (end.place - place).norm() <= settings_.radius_m;
    const double share = report_share(view, place.norm());
    candidates_.push_back({next_id_++,
                           {settings_.settling_reports, settings_.steadying_m2},
                           1,
                           settings_.first_log_odds * share});
    candidates_.back().place.add(view.world_from_robot * place, view.robot(), std::max(share, least_weight));
  }
}

bool Grid::is_near_a_candidate(const View& view, const Eigen::Vector2d& place) const {
  const Eigen::Vector2d in_world = view.world_from_robot * place;
  return std::ranges::any_of(candidates_, [&](const Candidate& candidate) {
    const double to_foot = (candidate.place.foot() - in_world).norm();
    const double to_expected = (candidate.place.seen_from(view.robot()) - in_world).norm();
    return std::min(to_foot, to_expected) < settings_.radius_m;
  });
}

bool Grid::proven_free(const View& view, const Eigen::Vector2d& place) const {
  return place.norm() <= settings_.range_m && std::ranges::any_of(view.rays, [&](const FloorRay& ray) {
           return distance_to_segment(place, ray.near, ray.free) <= settings_.resolution_m;
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
    const Eigen::Vector2d foot = candidate.place.foot();
    const bool stands = std::ranges::none_of(confirmed, [&](const ConfirmedObstacle& surer) {
      return (surer.place - foot).norm() < settings_.merge_m;
    });
    if (stands) confirmed.push_back({candidate.id, foot, candidate.reports});
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
