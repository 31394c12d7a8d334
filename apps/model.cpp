#include "model.h"

#include "natural_units.h"
#include "tb/csim/csim.h"

namespace floorline::app {
namespace {

using Pictures = std::vector<std::pair<std::string, cv::Mat>>;

class GoldenModel : public Model {
 public:
  explicit GoldenModel(const Drive& drive) : pipeline_(drive.configuration().ring_rows()) {}

  Finding run(const DriveFrame& frame) override {
    stages_ = pipeline_.process(frame.image, frame.golden);
    return {stages_.points, stages_.obstacles};
  }

  Pictures pictures() const override {
    const auto mask = [](const golden::Masks& masks) { return cv::Mat((masks.low & 128) | masks.high); };
    return {{"luma", stages_.luma},
            {"frame_ring", stages_.pairs.reference},
            {"difference", stages_.difference},
            {"displacement", stages_.motion},
            {"gaussian", stages_.blurred},
            {"binarize", mask(stages_.binary)},
            {"erode", mask(stages_.eroded)},
            {"roi", mask(stages_.region)}};
  }

 private:
  golden::Pipeline pipeline_;
  golden::Stages stages_;
};

class CsimModel : public Model {
 public:
  CsimModel(const Drive& drive, bool capture)
      : simulation_(drive.sequence().camera().size),
        lines_(drive.configuration().lines()),
        capturing_(capture) {}

  Finding run(const DriveFrame& frame) override {
    const FrameOutput output =
        simulation_.run(frame.image, frame.kernel, lines_, capturing_ ? &capture_ : nullptr);
    return {in_natural_units(output.points), in_natural_units(output.obstacles)};
  }

  Pictures pictures() const override {
    const auto mask = [](const cv::Mat& bits) { return cv::Mat(((bits & 1) * 128) | ((bits & 2) * 255)); };
    return {{"luma", capture_.luma},
            {"frame_ring", capture_.reference},
            {"difference", capture_.difference},
            {"displacement", motion_grey(capture_.motion)},
            {"gaussian", capture_.blurred},
            {"binarize", mask(capture_.binary)},
            {"erode", mask(capture_.eroded)},
            {"roi", mask(capture_.region)}};
  }

 private:
  CSimulation simulation_;
  std::vector<LineSetup> lines_;
  bool capturing_;
  StageCapture capture_;
};

}  // namespace

std::unique_ptr<Model> golden_model(const Drive& drive) { return std::make_unique<GoldenModel>(drive); }

std::unique_ptr<Model> csim_model(const Drive& drive, bool capture) {
  return std::make_unique<CsimModel>(drive, capture);
}

}  // namespace floorline::app
