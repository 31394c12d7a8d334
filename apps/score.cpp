#include "score.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "golden/cluster.h"
#include "host/error.h"
#include "host/geometry.h"
#include "host/grid.h"
#include "progress.h"

namespace floorline::app {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;

double ratio(long part, long whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

/// Floor places of obstacles whose foot is in the image; a clipped one says only that something is nearer
/// than that.
std::vector<Vector2d> places(const std::vector<golden::Obstacle>& obstacles) {
  std::vector<Vector2d> result;
  for (const golden::Obstacle& obstacle : obstacles) {
    if (!obstacle.nearest.contact.clipped) result.emplace_back(obstacle.nearest.x, obstacle.nearest.y);
  }
  return result;
}

/// The grid's confirmed obstacles that the camera sees now, robot frame.
std::vector<Vector2d> confirmed_in_view(const Grid& grid, const Drive& drive,
                                        const Eigen::Isometry3d& world_from_robot) {
  const Sequence& sequence = drive.sequence();
  const Eigen::Matrix3d pixel_map = pixel_from_floor(sequence.camera().matrix, sequence.robot_from_camera());
  const Eigen::Isometry3d robot_from_world = isometry(planar(world_from_robot)).inverse();
  const cv::Rect roi = drive.configuration().roi();
  std::vector<Vector2d> result;
  for (const ConfirmedObstacle& obstacle : grid.confirmed()) {
    const Eigen::Vector3d place =
        robot_from_world * Eigen::Vector3d(obstacle.place.x(), obstacle.place.y(), 0);
    const Eigen::Vector3d pixel = pixel_map * Eigen::Vector3d(place.x(), place.y(), 1);
    const bool ahead = pixel.z() > 0;
    const cv::Point2d at(pixel.x() / pixel.z(), pixel.y() / pixel.z());
    if (ahead && roi.contains(cv::Point(cvRound(at.x), cvRound(at.y)))) result.emplace_back(place.head<2>());
  }
  return result;
}

/// What the mask says of a contact point: right, wrong, or nothing.
std::optional<bool> judged(const cv::Mat& mask, const golden::Contact& contact) {
  constexpr int tolerance = 3;
  const auto at = [&](int row) { return mask.at<uchar>(row, contact.u); };
  int row = std::min(contact.v + tolerance, mask.rows - 1);
  const int highest = std::max(contact.v - tolerance, 0);
  while (row > highest && at(row) == render::MaskValue::floor) --row;  // still on the floor below the foot
  while (row > 0 && at(row) == render::MaskValue::unknown)
    --row;  // the unknown band between floor and obstacle
  if (at(row) == render::MaskValue::unknown) return std::nullopt;
  return at(row) != render::MaskValue::floor;
}

MaskScore score_contacts(const std::vector<golden::FloorPoint>& points, const cv::Mat& mask) {
  MaskScore score;
  for (const golden::FloorPoint& point : points) {
    if (point.contact.clipped || point.contact.u < 0 || point.contact.u >= mask.cols) continue;
    const std::optional<bool> right = judged(mask, point.contact);
    if (right) ++(*right ? score.right : score.wrong);
  }
  return score;
}

cv::Mat high_mask(const Model& model) {
  for (const auto& [name, picture] : model.pictures()) {
    if (name == "roi") return picture == 255;
  }
  throw std::logic_error("the model has no region of interest");
}

/// One sequence while its frames come in.
class Scorer {
 public:
  explicit Scorer(const Drive& drive) : drive_(drive), grid_(GridSettings()) {
    const std::optional<fs::path> folder = drive.sequence().truth_folder();
    if (!folder)
      throw Error(
          "the sequence has no ground truth to score against; 'floorline render' makes one with truth.");
    if (!fs::exists(*folder / "contacts.json")) return;
    truth_ = render::read_truth(*folder / "contacts.json");
    if (static_cast<int>(truth_.size()) != drive.frame_count())
      throw Error(fmt::format("{}: has {} frames, the sequence {}.", (*folder / "contacts.json").string(),
                              truth_.size(), drive.frame_count()));
    score_.has_contacts = true;
  }

  void add(const DriveFrame& frame, const Finding& finding, const Model& model) {
    grid_.add(planar(frame.world_from_robot), floor_rays(frame.golden, finding.points),
              frame.plan.parallax_px);
    if (!frame.plan.mature) return;
    ++score_.frames;
    if (score_.has_contacts) {
      const render::TrueFrame& truth = truth_[frame.index];
      score_.per_frame += render::score_reports(places(finding.obstacles), truth, {});
      // At the first one hardly anything can be confirmed yet, however well it is seen.
      if (score_.frames >= 2)
        score_.confirmed +=
            render::score_reports(confirmed_in_view(grid_, drive_, frame.world_from_robot), truth, {});
    }
    if (drive_.sequence().camera().distorted()) return;  // the masks are for the images before rectification
    const cv::Mat mask = drive_.sequence().truth_mask(frame.index);
    score_.pixels += render::score_pixels(high_mask(model), mask, drive_.configuration().roi().y);
    score_.mask += score_contacts(finding.points, mask);
  }

  const DetectionScore& score() const { return score_; }

 private:
  const Drive& drive_;
  Grid grid_;
  std::vector<render::TrueFrame> truth_;
  DetectionScore score_;
};

void append_figures(std::vector<report::Figure>& figures, const render::Score& score, const std::string& name,
                    const std::string& label) {
  using report::Relation;
  figures.push_back({name + ".recall", label + ": recall", score.recall(), Relation::at_least, 0.9, ""});
  figures.push_back(
      {name + ".precision", label + ": precision", score.precision(), Relation::at_least, 0.9, ""});
  figures.push_back({name + ".median_error_m", label + ": median position error", score.median_error_m(),
                     Relation::at_most, 0.05, "m"});
  figures.push_back({name + ".duplicate_share", label + ": duplicates", score.duplicate_share(),
                     Relation::at_most, 0.02, ""});
  figures.push_back({name + ".marking_share", label + ": floor markings reported", score.marking_share(),
                     Relation::at_most, 0.01, ""});
}

}  // namespace

double MaskScore::precision() const { return ratio(right, right + wrong); }

MaskScore& MaskScore::operator+=(const MaskScore& other) {
  right += other.right;
  wrong += other.wrong;
  return *this;
}

DetectionScore& DetectionScore::operator+=(const DetectionScore& other) {
  frames += other.frames;
  per_frame += other.per_frame;
  confirmed += other.confirmed;
  pixels += other.pixels;
  mask += other.mask;
  has_contacts = has_contacts || other.has_contacts;
  return *this;
}

DetectionScore score(Drive& drive, Model& model, const std::string& task) {
  Scorer scorer(drive);
  Progress progress(task);
  for (int i = 0; i < drive.frame_count(); ++i) {
    const DriveFrame frame = drive.next();
    const Finding finding = model.run(frame);
    scorer.add(frame, finding, model);
    progress.advance(i + 1, drive.frame_count());
  }
  return scorer.score();
}

std::vector<report::Figure> score_figures(const DetectionScore& score) {
  std::vector<report::Figure> figures;
  if (!score.has_contacts) return figures;
  append_figures(figures, score.per_frame, "frame", "each frame");
  append_figures(figures, score.confirmed, "confirmed", "confirmed in the grid");
  return figures;
}

}  // namespace floorline::app
