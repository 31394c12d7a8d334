#include "host/mount_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core/eigen.hpp>
#include <opencv2/core/optim.hpp>
#include <opencv2/imgproc.hpp>

#include "host/error.h"
#include "host/geometry.h"

namespace floorline {
namespace {

/// Differences above this are something else than the floor.
constexpr double residual_cap = 20;
/// Baseline of a pair as a share of the camera's height: less says little, more leaves little floor in
/// common.
constexpr double least_baseline = 0.25;
constexpr int most_pairs = 12;
/// The corridor that the robot drives through, in heights of the camera: what lies in it is floor.
constexpr double corridor_half_width = 1.5;
constexpr double corridor_length = 12;

/// Image pyramid: blur against false minima first, full sharpness last.
struct Level {
  double blur_px;
  double angle_step_rad;
  double height_step;  ///< Share of the height.
};
constexpr Level levels[] = {{8, 0.03, 0.08}, {3, 0.01, 0.03}, {1, 0.003, 0.01}};

struct Pair {
  int reference;
  int current;
};

/// Pixels that see the corridor under a mount.
cv::Mat corridor(const Camera& camera, const MountAngles& angles) {
  const Eigen::Matrix3d floor = floor_from_pixel(camera.matrix, robot_from_camera(angles));
  cv::Mat mask = cv::Mat::zeros(camera.size, CV_8UC1);
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const Eigen::Vector3d ray = floor * Eigen::Vector3d(u, v, 1);
      const Eigen::Vector2d place = ray.hnormalized() / angles.height_m;
      const bool below_horizon = ray.z() > 0;
      if (below_horizon && place.x() < corridor_length && std::abs(place.y()) < corridor_half_width) {
        mask.at<uchar>(v, u) = 255;
      }
    }
  }
  return mask;
}

/// For frames spread over the drive, the first later frame with the baseline.
std::vector<Pair> pairs_of(const std::vector<Eigen::Isometry3d>& poses, double baseline_m) {
  std::vector<Pair> pairs;
  const int count = static_cast<int>(poses.size());
  const int stride = std::max(1, count / most_pairs);
  for (int i = 0; i < count; i += stride) {
    for (int j = i + 1; j < count; ++j) {
      if ((poses[i].translation() - poses[j].translation()).norm() < baseline_m) continue;
      pairs.push_back({i, j});
      break;
    }
  }
  return pairs;
}

class GroundResidual : public cv::MinProblemSolver::Function {
 public:
  GroundResidual(const Camera& camera, const MountAngles& guess, const std::vector<cv::Mat>& frames,
                 const std::vector<Eigen::Isometry3d>& poses, const std::vector<Pair>& pairs, double blur_px)
      : camera_(camera), guess_(guess), poses_(poses), pairs_(pairs) {
    const cv::Mat mask = corridor(camera, guess);
    window_ = cv::boundingRect(mask);
    corridor_ = mask(window_);
    for (const cv::Mat& frame : frames) {
      cv::GaussianBlur(frame, blurred_.emplace_back(), {0, 0}, blur_px);
      blurred_.back().convertTo(blurred_.back(), CV_32F);
    }
  }

  int getDims() const override { return 3; }

  /// x: pitch, roll, logarithm of the height over the guess.
  double calc(const double* x) const override { return residual(angles(x)); }

  MountAngles angles(const double* x) const {
    MountAngles angles = guess_;
    angles.pitch_rad = x[0];
    angles.roll_rad = x[1];
    angles.height_m *= std::exp(x[2]);
    return angles;
  }

  double residual(const MountAngles& angles) const {
    const Eigen::Isometry3d mount = robot_from_camera(angles);
    double sum = 0;
    double count = 0;
    for (const Pair& pair : pairs_) {
      const auto [pair_sum, pair_count] = compare(pair, mount);
      sum += pair_sum;
      count += pair_count;
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::max();
  }

 private:
  /// Sum of the capped differences of a pair, and of how many pixels.
  std::pair<double, double> compare(const Pair& pair, const Eigen::Isometry3d& mount) const {
    const Eigen::Isometry3d reference_from_current = poses_[pair.reference].inverse() * poses_[pair.current];
    cv::Matx33d homography;
    cv::eigen2cv(ground_homography(camera_.matrix, mount, reference_from_current), homography);
    const cv::Matx33d image_from_window(1, 0, window_.x, 0, 1, window_.y, 0, 0, 1);
    constexpr double unknown = -1000;  // Marks pixels without a counterpart.
    cv::Mat warped, difference;
    cv::warpPerspective(blurred_[pair.reference], warped, homography * image_from_window, window_.size(),
                        cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(unknown));
    cv::absdiff(warped, blurred_[pair.current](window_), difference);
    const cv::Mat compared = (warped >= 0) & corridor_;
    const int count = cv::countNonZero(compared);
    return {cv::mean(cv::min(difference, residual_cap), compared)[0] * count, count};
  }

  const Camera& camera_;
  const MountAngles guess_;
  const std::vector<Eigen::Isometry3d>& poses_;
  const std::vector<Pair>& pairs_;
  cv::Rect window_;
  cv::Mat corridor_;  ///< Mask within the window.
  std::vector<cv::Mat> blurred_;
};

}  // namespace

MountFit fit_mount(const Camera& camera, const MountAngles& guess, const std::vector<cv::Mat>& frames,
                   const std::vector<Eigen::Isometry3d>& world_from_robot) {
  require_floor_in_view(camera, robot_from_camera(guess));
  const std::vector<Pair> pairs = pairs_of(world_from_robot, least_baseline * guess.height_m);
  if (pairs.empty()) {
    throw Error(
        "The robot hardly moves in this sequence: record one in which it drives farther than half the "
        "camera's height.");
  }
  MountFit fit = {guess, 0, 0, static_cast<int>(pairs.size())};
  for (const Level& level : levels) {
    const auto residual =
        cv::makePtr<GroundResidual>(camera, fit.angles, frames, world_from_robot, pairs, level.blur_px);
    const cv::Mat_<double> step =
        (cv::Mat_<double>(1, 3) << level.angle_step_rad, level.angle_step_rad, level.height_step);
    cv::Mat_<double> x = (cv::Mat_<double>(1, 3) << fit.angles.pitch_rad, fit.angles.roll_rad, 0);
    fit.residual_before = residual->residual(guess);
    const cv::TermCriteria until(cv::TermCriteria::MAX_ITER | cv::TermCriteria::EPS, 120, 1e-6);
    fit.residual = cv::DownhillSolver::create(residual, step, until)->minimize(x);
    fit.angles = residual->angles(x.ptr<double>());
  }
  // The coarse levels can lead away from a good guess, where a thing in the corridor outweighs the floor.
  if (fit.residual > fit.residual_before) fit = {guess, fit.residual_before, fit.residual_before, fit.pairs};
  return fit;
}

}  // namespace floorline
