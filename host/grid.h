/// Occupancy grid in the odometry frame: what stands on the floor, what floor the lines prove to be free, and
/// which obstacles enough frames have seen at one place. Every frame counts by what its baseline lets it see:
/// the parallax of an obstacle, which falls with its distance.
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
  double first_log_odds = 1;        ///< Of an obstacle when lines end where nothing was known.
  double report_log_odds = 2.2;     ///< Added when lines of a later frame end there.
  double absence_log_odds = -1.4;   ///< Added when none ends there and one passes on.
  double confirmed_log_odds = 1.8;  ///< From here on an obstacle is confirmed.
  double limit_log_odds =
      4;  ///< Cells and obstacles stay within +- this, so that they can change their mind.
  double report_parallax_px = 1.15;  ///< Hits and reports count in full from this parallax on...
  double absence_parallax_px = 0.9;  ///< ...what is not seen from this; below in proportion.
  double radius_m = 0.25;            ///< Lines that end nearer to an obstacle than this end at it.
  double merge_m = 0.72;  ///< Of confirmed obstacles nearer to each other than this, the surer one stands.
  double settling_reports = 3.8;  ///< An obstacle's place follows from about so many frames.
  double steadying_m2 = 0.45;  ///< Sum of squares of the way driven that tells a foot from a body: below, all
                               ///< is taken for a foot.
};

/// The distances above, which suit a camera at 0.6 m, in proportion to the height of another camera.
GridSettings grid_settings(double camera_height_m);

/// An obstacle that enough evidence speaks for.
struct ConfirmedObstacle {
  int id;                 ///< Stays with the obstacle.
  Eigen::Vector2d place;  ///< Of its foot, odometry frame, metres.
  int reports;            ///< Frames that saw it.
};

/// Where the foot of an obstacle is by the places at which it was seen. A true foot stays at P; a point at
/// height h of its body, camera at height H, appears on the floor at C + (P - C) H / (H - h), so that it
/// slides by b = -h / (H - h) of the way that the robot's place C moves. P and b follow by least squares from
/// the last frames, b drawn to 0 as long as the robot has hardly moved.
class SlidingPlace {
 public:
  /// memory: frames that count, in the mean; steadying_m2: as in GridSettings.
  SlidingPlace(double memory, double steadying_m2);

  /// Seen at `place` by the robot at `robot`, odometry frame; weight > 0.
  void add(const Eigen::Vector2d& place, const Eigen::Vector2d& robot, double weight);

  Eigen::Vector2d foot() const;

  /// Where it should appear to the robot at `robot`.
  Eigen::Vector2d seen_from(const Eigen::Vector2d& robot) const;

 private:
  double slide() const;

  double keep_;  ///< Share of its weight that a frame keeps when one more comes.
  double steadying_m2_;
  double weight_ = 0;
  Eigen::Vector2d mean_place_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_robot_ = Eigen::Vector2d::Zero();
  double robot_square_ = 0;   ///< Weighted sum of squares of the robot's places about their mean...
  double cross_product_ = 0;  ///< ...and of their products with the places seen.
};

class Grid {
 public:
  explicit Grid(const GridSettings& settings);

  /// One frame: what its lines say, and the parallax of its pair as PlannedFrame has it.
  void add(const PlanarPose& robot, const std::vector<FloorRay>& rays, double parallax_px);

  /// Confirmed and not disproved since, in the order of their ids.
  std::vector<ConfirmedObstacle> confirmed() const;

  /// Probability that the cell at a place (odometry frame) is occupied; 0.5 where nothing is known.
  double occupancy(const Eigen::Vector2d& place) const;

  /// Writes map.png and map.yaml as ROS's map_server reads them: 0 occupied, 254 free, 205 unknown; Y grows
  /// upward. Throws Error when nothing was added or the files cannot be written.
  void write(const std::filesystem::path& folder) const;

 private:
  using Cell = std::pair<int, int>;

  /// What may stand at one place.
  struct Candidate {
    int id;
    SlidingPlace place;
    int reports;
    double log_odds;
  };

  /// A frame as it looks at the floor.
  struct View {
    Eigen::Isometry2d world_from_robot;
    const std::vector<FloorRay>& rays;
    double parallax_px;
    Eigen::Vector2d robot() const { return world_from_robot.translation(); }
  };

  /// Where a line ends, robot frame.
  struct End {
    Eigen::Vector2d place;
    bool taken = false;  ///< By an obstacle.
  };

  Cell cell_at(const Eigen::Vector2d& place) const;
  void add_rays(const View& view);
  std::vector<End> ends(const View& view) const;
  void see_again(const View& view, std::vector<End>& ends);
  void discover(const View& view, std::vector<End>& ends);
  bool is_near_a_candidate(const View& view, const Eigen::Vector2d& place) const;
  bool proven_free(const View& view, const Eigen::Vector2d& place) const;
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
