/// The two models behind one face: golden and C simulation, frame in, contact points and obstacles out.
#ifndef FLOORLINE_APPS_MODEL_H
#define FLOORLINE_APPS_MODEL_H

#include <memory>
#include <string>

#include "drive.h"
#include "golden/pipeline.h"

namespace floorline::app {

/// What a model found in one frame, in natural units.
struct Finding {
  std::vector<golden::FloorPoint> points;  ///< One a contact point.
  std::vector<golden::Obstacle> obstacles;
};

class Model {
 public:
  virtual ~Model() = default;
  virtual Finding run(const DriveFrame& frame) = 0;
  /// Pictures of the stages of the last frame by kernel name; masks are 0, 128 (low) and 255 (high).
  virtual std::vector<std::pair<std::string, cv::Mat>> pictures() const = 0;
};

std::unique_ptr<Model> golden_model(const Drive& drive);

/// `capture`: keep what runs between the kernels, so that pictures() works; slower.
std::unique_ptr<Model> csim_model(const Drive& drive, bool capture);

}  // namespace floorline::app

#endif
