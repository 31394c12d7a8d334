#include "stage_check.h"

#include <algorithm>
#include <cmath>

#include "golden/difference.h"
#include "golden/displacement.h"
#include "golden/erode.h"
#include "golden/gaussian.h"
#include "golden/luma.h"
#include "golden/otsu.h"
#include "golden/roi.h"
#include "host/fixed_point.h"
#include "natural_units.h"

namespace floorline::app {
namespace {

enum ResultStage { otsu_stage = kImageStages, polar_stage, birdseye_stage, cluster_stage };

/// Masks of the golden model as the kernels' two bits.
cv::Mat to_bits(const golden::Masks& masks) { return (masks.high & 2) + (masks.low & 1); }

golden::Masks from_bits(const cv::Mat& bits) { return {(bits & 2) != 0, (bits & 1) != 0}; }

double worst_difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

StagePair compared(const cv::Mat& kernel, const cv::Mat& golden) {
  return {kernel, golden, worst_difference(kernel, golden)};
}

/// Finds the least coordinate error that explains what the frame ring read. The homography in double
/// precision says where pixel (u, v) lies in the reference; the kernel's pixel is explained by any place near
/// there that gives its values.
class RingCheck {
 public:
  RingCheck(const cv::Mat& reference, const golden::Parameters& parameters, int ring_rows)
      : reference_(reference),
        homography_(parameters.homography),
        lost_rows_(parameters.replace_reference ? reference.rows - ring_rows : -2 * ring_rows) {}

  /// Greatest error over the frame, pixels.
  double worst(const StageCapture& capture, const golden::PixelPairs& golden) const {
    double worst = 0;
    for (int v = 0; v < capture.luma.rows; ++v) {
      for (int u = 0; u < capture.luma.cols; ++u) worst = std::max(worst, error(capture, golden, u, v));
    }
    return worst;
  }

 private:
  /// Steps of the interpolation in a pixel.
  static constexpr int kSteps = 64;
  /// Steps on each side that are tried, and the error, in pixels, of what no place among them explains.
  static constexpr int kTried = 4;
  static constexpr double kReach = 4;

  double error(const StageCapture& capture, const golden::PixelPairs& golden, int u, int v) const {
    const bool kernel_valid = capture.valid.at<uchar>(v, u) != 0;
    const bool golden_valid = golden.valid.at<uchar>(v, u) != 0;
    if (!kernel_valid && !golden_valid) return 0;
    const cv::Point2d place = mapped(u, v);
    if (kernel_valid != golden_valid) return border_distance(place, v);
    const int reference = capture.reference.at<uchar>(v, u), gradient = capture.gradient.at<uchar>(v, u);
    const bool same =
        reference == golden.reference.at<uchar>(v, u) && gradient == golden.gradient.at<uchar>(v, u);
    return same ? 0 : explaining_distance(place, reference, gradient);
  }

  cv::Point2d mapped(int u, int v) const {
    const cv::Vec3d p = homography_ * cv::Vec3d(u, v, 1);
    return {p[0] / p[2], p[1] / p[2]};
  }

  /// How far the place is from where validity changes: the image's border or the oldest row that the ring
  /// holds.
  double border_distance(cv::Point2d place, int v) const {
    const double oldest_row = v + lost_rows_ + 1;
    return std::min({std::abs(place.x + 0.5), std::abs(place.x - reference_.cols + 0.5),
                     std::abs(place.y + 0.5), std::abs(place.y - reference_.rows + 0.5),
                     std::abs(place.y - oldest_row)});
  }

  /// Least distance (the greater of its x and y parts), in the interpolation's steps, at which the reference
  /// interpolates to `reference` with that gradient.
  double explaining_distance(cv::Point2d place, int reference, int gradient) const {
    const cv::Point steps(cvFloor(place.x * kSteps + 0.5), cvFloor(place.y * kSteps + 0.5));
    double least = kReach;
    for (int y = -kTried; y <= kTried; ++y) {
      for (int x = -kTried; x <= kTried; ++x) {
        const cv::Point at = steps + cv::Point(x, y);
        const double distance =
            std::max(std::abs(at.x / double(kSteps) - place.x), std::abs(at.y / double(kSteps) - place.y));
        if (distance < least && interpolates_to(at, reference, gradient)) least = distance;
      }
    }
    return least;
  }

  bool interpolates_to(cv::Point steps, int reference, int gradient) const {
    const int column = cvFloor(double(steps.x) / kSteps), row = cvFloor(double(steps.y) / kSteps);
    const int across = steps.x - column * kSteps, down = steps.y - row * kSteps;
    const int a = clamped(column, row), b = clamped(column + 1, row), c = clamped(column, row + 1),
              d = clamped(column + 1, row + 1);
    const int sum =
        (kSteps - down) * (kSteps * a + across * (b - a)) + down * (kSteps * c + across * (d - c));
    return (sum + kSteps * kSteps / 2) / (kSteps * kSteps) == reference &&
           std::max(std::abs(a - d), std::abs(b - c)) == gradient;
  }

  int clamped(int x, int y) const {
    return reference_.at<uchar>(std::clamp(y, 0, reference_.rows - 1), std::clamp(x, 0, reference_.cols - 1));
  }

  const cv::Mat& reference_;
  cv::Matx33d homography_;
  int lost_rows_;  ///< Row v overwrites row v + lost_rows_ of the reference.
};

/// Contacts and counts that differ from the golden ones.
double polar_faults(const golden::PolarHistogram& expected, const std::vector<golden::Contact>& contacts,
                    const std::vector<LineCount>& counts) {
  double faults =
      std::abs(static_cast<double>(expected.contacts.size()) - static_cast<double>(contacts.size()));
  for (std::size_t i = 0; i < std::min(expected.contacts.size(), contacts.size()); ++i)
    faults += !(expected.contacts[i] == contacts[i]);
  for (const LineCount& count : counts)
    faults += expected.counts.at(count.line.to_int()) != count.count.to_int();
  return faults;
}

/// Greatest distance between kernel and golden floor points within the range for which the packing error is
/// bounded.
double birdseye_error(const std::vector<golden::FloorPoint>& expected,
                      const std::vector<FloorPoint>& points) {
  double worst = expected.size() == points.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(expected.size(), points.size()); ++i) {
    if (std::hypot(expected[i].x, expected[i].y) > kBirdseyeRange) continue;
    worst =
        std::max(worst, std::hypot(expected[i].x - metres(points[i].x), expected[i].y - metres(points[i].y)));
  }
  return worst;
}

/// The points as the cluster kernel compares them: coordinates cut down to Q8.9 (hls/cluster.h).
std::vector<golden::FloorPoint> cut_for_clustering(std::vector<golden::FloorPoint> points) {
  constexpr double steps_per_metre = 512;
  for (golden::FloorPoint& point : points) {
    point.x = std::floor(point.x * steps_per_metre) / steps_per_metre;
    point.y = std::floor(point.y * steps_per_metre) / steps_per_metre;
  }
  return points;
}

/// Obstacles whose lines or representative differ from the golden ones.
double cluster_faults(const std::vector<golden::Obstacle>& expected, const std::vector<Obstacle>& obstacles) {
  double faults = std::abs(static_cast<double>(expected.size()) - static_cast<double>(obstacles.size()));
  for (std::size_t i = 0; i < std::min(expected.size(), obstacles.size()); ++i) {
    const golden::Contact& nearest = expected[i].nearest.contact;
    faults += !(expected[i].first_line == obstacles[i].first_line.to_int() &&
                expected[i].last_line == obstacles[i].last_line.to_int() &&
                nearest.u == obstacles[i].u.to_int() && nearest.v == obstacles[i].v.to_int());
  }
  return faults;
}

}  // namespace

const std::vector<StageBound>& stage_bounds() {
  static const std::vector<StageBound> bounds = {
      {"luma", "worst pixel", "LSB", 1},
      {"frame_ring", "worst mapped coordinate", "px", 0.5},
      {"difference", "worst pixel", "LSB", 0},
      {"displacement", "worst mask", "LSB", 0},
      {"gaussian", "worst pixel", "LSB", 1},
      {"binarize", "worst mask", "LSB", 0},
      {"erode", "worst mask", "LSB", 0},
      {"roi", "worst mask", "LSB", 0},
      {"otsu", "worst threshold", "LSB", 0},
      {"polar", "counts and contacts that differ", "", 0},
      {"birdseye", "worst point within 4 m", "m", kBirdseyeErrorBound},
      {"cluster", "obstacles that differ", "", 0},
  };
  return bounds;
}

StageCheck::StageCheck(int ring_rows)
    : ring_(ring_rows), ring_rows_(ring_rows), worst_(stage_bounds().size()) {}

StagePairs StageCheck::add(const cv::Mat& image, const golden::Parameters& parameters,
                           const StageCapture& capture, const FrameOutput& output) {
  const golden::PixelPairs ring =
      ring_.pair(capture.luma, parameters.homography, parameters.replace_reference);
  const RingCheck ring_check(reference_, parameters, ring_rows_);
  const golden::PixelPairs pairs{capture.luma, capture.reference, capture.gradient, capture.valid != 0};
  const int high = golden::high_threshold(parameters.threshold, capture.otsu_threshold);
  const golden::Masks binary = from_bits(capture.binary), eroded = from_bits(capture.eroded);

  StagePairs stages = {
      compared(capture.luma, golden::luma(image)),
      {capture.reference, ring.reference, ring_check.worst(capture, ring)},
      compared(capture.difference, golden::difference(pairs)),
      compared(motion_grey(capture.motion),
               golden::displacement(capture.difference, capture.gradient, parameters.displacement)),
      compared(capture.blurred, golden::gaussian(capture.difference)),
      compared(capture.binary, to_bits(golden::binarize(capture.blurred, high, parameters.threshold.low))),
      compared(capture.eroded, to_bits(parameters.erode_high ? golden::erode(binary) : binary)),
      compared(capture.region,
               to_bits(golden::roi(eroded, parameters.roi_first_row, parameters.roi_last_row)))};
  for (int stage = 0; stage < kImageStages; ++stage)
    worst_[stage] = std::max(worst_[stage], stages[stage].worst);
  check_results(parameters, capture, output);
  if (parameters.replace_reference) reference_ = capture.luma.clone();
  return stages;
}

void StageCheck::check_results(const golden::Parameters& parameters, const StageCapture& capture,
                               const FrameOutput& output) {
  const std::vector<golden::Contact> contacts = in_natural_units(capture.contacts);
  const auto note = [&](ResultStage stage, double value) { worst_[stage] = std::max(worst_[stage], value); };
  note(otsu_stage, std::abs(capture.otsu_threshold - otsu_before_));
  otsu_before_ = golden::otsu(capture.blurred);
  note(polar_stage, polar_faults(golden::polar(from_bits(capture.region), motion_grey(capture.motion),
                                               parameters.lines, parameters.rule),
                                 contacts, output.counts));
  note(birdseye_stage, birdseye_error(golden::birdseye(contacts, parameters.birdseye), output.points));
  note(cluster_stage, cluster_faults(golden::cluster(cut_for_clustering(in_natural_units(output.points)),
                                                     parameters.cluster_gap_m, parameters.min_lines),
                                     output.obstacles));
}

std::vector<report::Figure> StageCheck::figures() const {
  std::vector<report::Figure> figures;
  for (std::size_t i = 0; i < worst_.size(); ++i) {
    const StageBound& bound = stage_bounds()[i];
    figures.push_back({.name = std::string(bound.name),
                       .label = std::string(bound.name) + ": " + std::string(bound.measure),
                       .value = worst_[i],
                       .relation = report::Relation::at_most,
                       .bound = bound.bound,
                       .unit = std::string(bound.unit)});
  }
  return figures;
}

}  // namespace floorline::app
