/// Ground truth of a sequence: what touches the floor where, frame by frame (truth/contacts.json).
#ifndef FLOORLINE_RENDER_TRUTH_H
#define FLOORLINE_RENDER_TRUTH_H

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace floorline::render {

using Polyline = std::vector<Eigen::Vector2d>;

/// Values of truth/masks; obstacle i has first_obstacle + i.
struct MaskValue {
  static constexpr int floor = 0, marking = 1, wall = 2, first_obstacle = 16, unknown = 255;
};

/// An obstacle as one frame sees it. Coordinates: robot frame of that frame, metres.
struct TrueObstacle {
  int id = 0;  ///< Index in the scene; MaskValue::first_obstacle + id in the masks.
  std::string kind;
  double height_m = 0;
  int visible_pixels = 0;
  double contact_share =
      0;  ///< Visible length of the contact curve over that of the side that faces the camera.
  std::vector<Polyline> contact;  ///< Visible pieces of the contact curve; one a leg for a chair.
};

struct TrueFrame {
  std::vector<TrueObstacle> obstacles;  ///< Those with a visible pixel.
  std::vector<Polyline> walls;          ///< Visible pieces of the walls' foot.
  std::vector<Polyline> markings;       ///< Closed polygons, visible or not.
};

/// Writes or reads truth/contacts.json. Throw Error with one sentence when the file cannot be
/// used.
void write_truth(const std::vector<TrueFrame>& frames, const std::filesystem::path& file);
std::vector<TrueFrame> read_truth(const std::filesystem::path& file);

}  // namespace floorline::render

#endif
