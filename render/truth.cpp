#include "truth.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "host/atomic_file.h"
#include "host/error.h"

namespace floorline::render {
namespace {

using nlohmann::json;

json to_json(const Polyline& polyline) {
  json points = json::array();
  for (const Eigen::Vector2d& point : polyline) points.push_back({point.x(), point.y()});
  return points;
}

json to_json(const std::vector<Polyline>& polylines) {
  json list = json::array();
  for (const Polyline& polyline : polylines) list.push_back(to_json(polyline));
  return list;
}

Polyline polyline_from(const json& points) {
  Polyline polyline;
  for (const json& point : points)
    polyline.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
  return polyline;
}

std::vector<Polyline> polylines_from(const json& list) {
  std::vector<Polyline> polylines;
  for (const json& points : list) polylines.push_back(polyline_from(points));
  return polylines;
}

json to_json(const TrueFrame& frame) {
  json obstacles = json::array();
  for (const TrueObstacle& obstacle : frame.obstacles) {
    obstacles.push_back({{"id", obstacle.id},
                         {"kind", obstacle.kind},
                         {"height_m", obstacle.height_m},
                         {"visible_pixels", obstacle.visible_pixels},
                         {"contact_share", obstacle.contact_share},
                         {"contact", to_json(obstacle.contact)}});
  }
  return {{"obstacles", obstacles}, {"walls", to_json(frame.walls)}, {"markings", to_json(frame.markings)}};
}

TrueFrame frame_from(const json& object) {
  TrueFrame frame;
  for (const json& entry : object.at("obstacles")) {
    TrueObstacle obstacle;
    entry.at("id").get_to(obstacle.id);
    entry.at("kind").get_to(obstacle.kind);
    entry.at("height_m").get_to(obstacle.height_m);
    entry.at("visible_pixels").get_to(obstacle.visible_pixels);
    entry.at("contact_share").get_to(obstacle.contact_share);
    obstacle.contact = polylines_from(entry.at("contact"));
    frame.obstacles.push_back(std::move(obstacle));
  }
  frame.walls = polylines_from(object.at("walls"));
  frame.markings = polylines_from(object.at("markings"));
  return frame;
}

}  // namespace

void write_truth(const std::vector<TrueFrame>& frames, const std::filesystem::path& file) {
  json list = json::array();
  for (const TrueFrame& frame : frames) list.push_back(to_json(frame));
  write_file(file, json{{"frames", list}}.dump() + "\n");
}

std::vector<TrueFrame> read_truth(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw Error(fmt::format("{}: cannot be read; the sequence has no ground truth.", file.string()));
  try {
    std::vector<TrueFrame> frames;
    const json root = json::parse(in);
    for (const json& frame : root.at("frames")) frames.push_back(frame_from(frame));
    return frames;
  } catch (const json::exception& error) {
    throw Error(fmt::format("{}: is no ground truth file: {}.", file.string(), error.what()));
  }
}

}  // namespace floorline::render
