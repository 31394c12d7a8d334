/// Occupancy grid in the odometry frame: what stands on the floor, what floor the lines prove to be free, and
/// which reports have been confirmed. Feed it mature frames only (PlannedFrame::mature): without a baseline
/// nothing is proven.
#ifndef FLOORLINE_HOST_GRID_H
#define FLOORLINE_HOST_GRID_H

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "golden/birdseye.h"
#include "golden/parameters.h"
#include "host/odometry.h"

namespace floorline {

/// What one line says of the floor, robot frame, metres.
struct FloorRay {
  Eigen::Vector2d near;  ///< Where the line's view of the floor begins.
  Eigen::Vector2d far;   ///< Where it ends.
  Eigen::Vector2d free;  ///< The floor is free from `near` to here.
  bool hit;              ///< An obstacle stands at `free`.
};

/// A ray a line: free up to the line's contact nearest to the robot; up to the far end without one; nowhere
/// when that contact is clipped, since the obstacle's foot lies nearer than the image shows. Lines that do
/// not see the floor give none.
std::vector<FloorRay> floor_rays(const golden::Parameters& parameters,
                                 const std::vector<golden::FloorPoint>& points);

struct GridSettings {
  double resolution_m = 0.05;
  double range_m = 5;           ///< Floor farther from the robot than this is not judged.
  double hit_log_odds = 0.85;   ///< Added where an obstacle stands.
  double free_log_odds = -0.4;  ///< Added where a ray passes.
  double limit_log_odds = 4;    ///< Cells stay within +- this, so that they can change their mind.
  int confirm_hits = 2;         ///< An obstacle is confirmed when so many...
  int confirm_window = 4;       ///< ...of the last so many frames with it in view reported it.
  double radius_m = 0.35;       ///< Reports nearer than this, or...
  double radius_share = 0.08;   ///< ...than this share of the distance, are the same obstacle.
};

/// The distances above, which suit a camera at 0.6 m, in proportion to the height of another camera.
GridSettings grid_settings(double camera_height_m);

/// An obstacle that several frames reported at one place.
struct ConfirmedObstacle {
  int id;                 ///< Stays with the obstacle.
  Eigen::Vector2d place;  ///< Mean of its reports, odometry frame, metres.
  int reports;            ///< Frames that reported it.
};

class Grid {
 public:
  explicit Grid(const GridSettings& settings);

  /// One frame: what its lines say and the obstacles it reports (robot frame).
  void add(const PlanarPose& robot, const std::vector<FloorRay>& rays,
           const std::vector<Eigen::Vector2d>& obstacles);

  /// Confirmed and not disproved since.
  std::vector<ConfirmedObstacle> confirmed() const;

  /// Probability that the cell at a place (odometry frame) is occupied; 0.5 where nothing is known.
  double occupancy(const Eigen::Vector2d& place) const;

  /// Writes map.png and map.yaml as ROS's map_server reads them: 0 occupied, 254 free, 205 unknown; Y grows
  /// upward. Throws Error when nothing was added or the files cannot be written.
  void write(const std::filesystem::path& folder) const;

 private:
  using Cell = std::pair<int, int>;

  /// Reports at one place.
  struct Candidate {
    int id;
    Eigen::Vector2d place;
    int reports;
    std::deque<bool> history;  ///< Of the last frames with it in view: reported or not.
    bool confirmed;
  };

  Cell cell_at(const Eigen::Vector2d& place) const;
  void add_rays(const PlanarPose& robot, const std::vector<FloorRay>& rays);
  void add_obstacles(const PlanarPose& robot, const std::vector<FloorRay>& rays,
                     const std::vector<Eigen::Vector2d>& obstacles);
  double radius_m(double distance_m) const;

  GridSettings settings_;
  std::map<Cell, double> log_odds_;
  std::vector<Candidate> candidates_;
  int next_id_ = 0;
};

}  // namespace floorline

#endif
