/// Occupancy grid in the odometry frame: what stands on the floor, what floor the lines prove to be free, and
/// which reports have been confirmed. Every frame counts by what its baseline lets it see: the parallax of an
/// obstacle, which falls with its distance.
#ifndef FLOORLINE_HOST_GRID_H
#define FLOORLINE_HOST_GRID_H

#include <Eigen/Geometry>
#include <cstdint>
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
  double range_m = 5;               ///< Floor farther from the robot than this is not judged.
  double hit_log_odds = 0.85;       ///< Added to a cell where an obstacle stands.
  double free_log_odds = -0.4;      ///< Added where a ray passes.
  double report_log_odds = 1.5;     ///< Added to an obstacle that a frame reports.
  double absence_log_odds = -1.2;   ///< Added to one in view that it does not report.
  double confirmed_log_odds = 1.8;  ///< From here on an obstacle is confirmed.
  double limit_log_odds =
      4;  ///< Cells and obstacles stay within +- this, so that they can change their mind.
  double report_parallax_px = 0.9;    ///< Hits and reports count in full from this parallax on...
  double absence_parallax_px = 1.85;  ///< ...what is not seen from this; below in proportion.
  double radius_m = 0.42;             ///< Reports nearer to an obstacle than this are of it.
  double merge_m = 0.6;  ///< Of confirmed obstacles nearer to each other than this, the surer one stands.
  double settling_reports = 3;  ///< An obstacle's place is the mean of about so many reports.
};

/// The distances above, which suit a camera at 0.6 m, in proportion to the height of another camera.
GridSettings grid_settings(double camera_height_m);

/// An obstacle that enough evidence speaks for.
struct ConfirmedObstacle {
  int id;                 ///< Stays with the obstacle.
  Eigen::Vector2d place;  ///< Odometry frame, metres.
  int reports;            ///< Frames that reported it.
};

class Grid {
 public:
  explicit Grid(const GridSettings& settings);

  /// One frame: what its lines say, the obstacles it reports (robot frame), and the parallax of its pair as
  /// PlannedFrame has it.
  void add(const PlanarPose& robot, const std::vector<FloorRay>& rays,
           const std::vector<Eigen::Vector2d>& obstacles, double parallax_px);

  /// Confirmed and not disproved since, in the order of their ids.
  std::vector<ConfirmedObstacle> confirmed() const;

  /// Probability that the cell at a place (odometry frame) is occupied; 0.5 where nothing is known.
  double occupancy(const Eigen::Vector2d& place) const;

  /// Writes map.png and map.yaml as ROS's map_server reads them: 0 occupied, 254 free, 205 unknown; Y grows
  /// upward. Throws Error when nothing was added or the files cannot be written.
  void write(const std::filesystem::path& folder) const;

 private:
  using Cell = std::pair<int, int>;

  /// What was reported at one place.
  struct Candidate {
    int id;
    Eigen::Vector2d place;
    int reports;
    double log_odds;
  };

  /// A frame as it looks at the floor.
  struct View {
    Eigen::Isometry2d world_from_robot;
    const std::vector<FloorRay>& rays;
    double parallax_px;
  };

  Cell cell_at(const Eigen::Vector2d& place) const;
  void add_rays(const View& view);
  void add_reports(const View& view, const std::vector<Eigen::Vector2d>& obstacles);
  bool in_view(const View& view, const Eigen::Vector2d& place) const;
  double report_share(const View& view, double distance_m) const;
  double absence_share(const View& view, double distance_m) const;
  double limited(double log_odds) const;

  GridSettings settings_;
  std::map<Cell, double> log_odds_;
  std::vector<Candidate> candidates_;
  int next_id_ = 0;
};

}  // namespace floorline

#endif
