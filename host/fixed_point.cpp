#include "host/fixed_point.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <string>

#include "host/error.h"

namespace floorline {
namespace {

constexpr int kNumeratorBits = 18;    // X and Y: Q14.18
constexpr int kDenominatorBits = 28;  // Z: Q4.28
constexpr double kLeastSingularRatio = 1e-12;

/// Checks that a matrix can be inverted, and scales it so that Z = 1 at the centre of the ROI.
Eigen::Matrix3d scaled(const Eigen::Matrix3d& m, cv::Rect roi, const std::string& name) {
  if (!m.allFinite())
    throw Error("The " + name + " holds a value that is no number: check calibration, mount and odometry.");
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(m);
  const Eigen::Vector3d pivots = lu.matrixLU().diagonal().cwiseAbs();
  if (pivots.minCoeff() <= kLeastSingularRatio * pivots.maxCoeff()) {
    throw Error("The " + name +
                " is singular: check that the camera is above the floor and not level with it.");
  }
  const Eigen::Vector3d centre(roi.x + (roi.width - 1) / 2.0, roi.y + (roi.height - 1) / 2.0, 1.0);
  const double z = m.row(2).dot(centre);
  if (std::abs(z) <= kLeastSingularRatio * m.row(2).cwiseAbs().dot(centre)) {
    throw Error("The horizon of the " + name +
                " runs through the centre of the ROI: move the ROI below the horizon.");
  }
  return m / z;
}

ap_int<32> quantise(double value, int fraction_bits, const std::string& name) {
  const double scaled_value = std::nearbyint(std::ldexp(value, fraction_bits));
  if (std::abs(scaled_value) > 2147483647.0) {
    throw Error("The " + name + " does not fit its registers: move the ROI farther below the horizon.");
  }
  return static_cast<long long>(scaled_value);
}

ProjectiveMap quantised(const Eigen::Matrix3d& m, const std::string& name) {
  const auto numerator = [&](double value) { return quantise(value, kNumeratorBits, name); };
  const auto denominator = [&](double value) { return quantise(value, kDenominatorBits, name); };
  return {numerator(m(0, 0)),   numerator(m(0, 1)),   numerator(m(0, 2)),
          numerator(m(1, 0)),   numerator(m(1, 1)),   numerator(m(1, 2)),
          denominator(m(2, 0)), denominator(m(2, 1)), denominator(m(2, 2))};
}

/// Greatest distance between two maps over the pixels of the ROI that `counts(Z, mapped point)` accepts.
template <typename Counts>
double greatest_distance(const Eigen::Matrix3d& exact, const Eigen::Matrix3d& packed, cv::Rect roi,
                         Counts counts) {
  double greatest = 0.0;
  for (int v = roi.y; v < roi.y + roi.height; ++v) {
    for (int u = roi.x; u < roi.x + roi.width; ++u) {
      const Eigen::Vector3d pixel(u, v, 1.0);
      const Eigen::Vector3d a = exact * pixel;
      if (!counts(a.z(), Eigen::Vector2d(a.hnormalized()))) continue;
      greatest = std::max(greatest, (Eigen::Vector3d(packed * pixel).hnormalized() - a.hnormalized()).norm());
    }
  }
  return greatest;
}

PackedMap accept(const ProjectiveMap& map, double error, double bound, const std::string& name,
                 const std::string& unit) {
  if (!(error <= bound)) {
    throw Error("Packing the " + name + " costs " + std::to_string(error) + " " + unit + ", more than " +
                std::to_string(bound) + ": move the ROI farther below the horizon.");
  }
  return {map, error};
}

}  // namespace

PackedMap pack_homography(const Eigen::Matrix3d& reference_from_current, cv::Size image, cv::Rect roi) {
  const std::string name = "ground homography";
  const Eigen::Matrix3d exact = scaled(reference_from_current, roi, name);
  const ProjectiveMap map = quantised(exact, name);
  const double error =
      greatest_distance(exact, unpack(map), roi, [&](double z, const Eigen::Vector2d& point) {
        return z > 0.0625 && z < 8.0 && point.x() > -1.0 && point.x() < image.width && point.y() > -1.0 &&
               point.y() < image.height;
      });
  return accept(map, error, kHomographyErrorBound, name, "pixels");
}

PackedMap pack_birdseye(const Eigen::Matrix3d& floor_from_pixel, cv::Rect roi) {
  const std::string name = "bird's-eye matrix";
  const Eigen::Matrix3d exact = scaled(floor_from_pixel, roi, name);
  const ProjectiveMap map = quantised(exact, name);
  const double error = greatest_distance(exact, unpack(map), roi, [](double z, const Eigen::Vector2d& point) {
    return z > 0.0 && point.norm() <= kBirdseyeRange;
  });
  return accept(map, error, kBirdseyeErrorBound, name, "metres");
}

Eigen::Matrix3d unpack(const ProjectiveMap& map) {
  const auto numerator = [](ap_int<32> value) { return std::ldexp(value.to_double(), -kNumeratorBits); };
  const auto denominator = [](ap_int<32> value) { return std::ldexp(value.to_double(), -kDenominatorBits); };
  Eigen::Matrix3d m;
  m << numerator(map.xu), numerator(map.xv), numerator(map.x1),  //
      numerator(map.yu), numerator(map.yv), numerator(map.y1),   //
      denominator(map.zu), denominator(map.zv), denominator(map.z1);
  return m;
}

}  // namespace floorline
