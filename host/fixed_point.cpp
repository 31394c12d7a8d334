#include "host/fixed_point.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string>

#include "host/error.h"

namespace floorline {
namespace {

constexpr int kNumeratorBits = 18;    // X and Y: Q14.18
constexpr int kDenominatorBits = 28;  // Z: Q4.28
constexpr double kLeastSingularRatio = 1e-12;

/// Whether the accelerator divides by this Z (hls/reciprocal.h).
bool resolved(double z) { return z > 1.0 / 16.0 && z < 8.0; }

Eigen::Vector3d centre_of(cv::Rect roi) {
  return {roi.x + (roi.width - 1) / 2.0, roi.y + (roi.height - 1) / 2.0, 1.0};
}

/// Checks that a matrix can be inverted, and scales it so that Z = 1 at the centre of the ROI.
Eigen::Matrix3d scaled(const Eigen::Matrix3d& m, cv::Rect roi, const std::string& name) {
  if (!m.allFinite()) {
    throw Error("The " + name + " holds a value that is no number: check calibration, mount and odometry.");
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(m);
  const Eigen::Vector3d pivots = lu.matrixLU().diagonal().cwiseAbs();
  if (pivots.minCoeff() <= kLeastSingularRatio * pivots.maxCoeff()) {
    throw Error("The " + name +
                " is singular: check that the camera is above the floor and not level with it.");
  }
  const double z = m.row(2).dot(centre_of(roi));
  if (std::abs(z) <= kLeastSingularRatio * m.row(2).cwiseAbs().dot(centre_of(roi))) {
    throw Error("The horizon of the " + name +
                " runs through the centre of the ROI: move the ROI below the horizon.");
  }
  return m / z;
}

ap_int<32> quantise(double value, int fraction_bits, const std::string& name) {
  const double units = std::nearbyint(std::ldexp(value, fraction_bits));
  if (std::abs(units) > std::numeric_limits<int>::max()) {
    throw Error("The " + name + " does not fit its registers: move the ROI farther below the horizon.");
  }
  return static_cast<int>(units);
}

double value_of(ap_int<32> packed, int fraction_bits) { return std::ldexp(packed.to_int(), -fraction_bits); }

/// Packs one row of a map. The constant makes up at the centre of the ROI for what rounding did to the
/// slopes.
void quantise_row(const Eigen::RowVector3d& row, const Eigen::Vector3d& centre, int fraction_bits,
                  const std::string& name, ap_int<32>& u, ap_int<32>& v, ap_int<32>& constant) {
  u = quantise(row[0], fraction_bits, name);
  v = quantise(row[1], fraction_bits, name);
  const double slopes = value_of(u, fraction_bits) * centre[0] + value_of(v, fraction_bits) * centre[1];
  constant = quantise(row.dot(centre) - slopes, fraction_bits, name);
}

ProjectiveMap quantised(const Eigen::Matrix3d& m, cv::Rect roi, const std::string& name) {
  const Eigen::Vector3d centre = centre_of(roi);
  ProjectiveMap map;
  quantise_row(m.row(0), centre, kNumeratorBits, name, map.xu, map.xv, map.x1);
  quantise_row(m.row(1), centre, kNumeratorBits, name, map.yu, map.yv, map.y1);
  quantise_row(m.row(2), centre, kDenominatorBits, name, map.zu, map.zv, map.z1);
  return map;
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

/// Pixel -> pixel from the image's middle.
Eigen::Affine2d from_middle(cv::Size image) {
  return Eigen::Affine2d(Eigen::Translation2d(-(image.width / 2), -(image.height / 2)));
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
  const ProjectiveMap map = quantised(from_middle(image) * exact, roi, name);
  const double error = greatest_distance(
      exact, unpack_homography(map, image), roi, [&](double z, const Eigen::Vector2d& point) {
        return resolved(z) && point.x() > -1.0 && point.x() < image.width && point.y() > -1.0 &&
               point.y() < image.height;
      });
  return accept(map, error, kHomographyErrorBound, name, "pixels");
}

PackedMap pack_birdseye(const Eigen::Matrix3d& floor_from_pixel, cv::Rect roi) {
  const std::string name = "bird's-eye matrix";
  const Eigen::Matrix3d exact = scaled(floor_from_pixel, roi, name);
  const ProjectiveMap map = quantised(exact, roi, name);
  const double error = greatest_distance(exact, unpack(map), roi, [](double z, const Eigen::Vector2d& point) {
    return resolved(z) && point.norm() <= kBirdseyeRange;
  });
  return accept(map, error, kBirdseyeErrorBound, name, "metres");
}

Eigen::Matrix3d unpack(const ProjectiveMap& map) {
  const auto numerator = [](ap_int<32> value) { return value_of(value, kNumeratorBits); };
  const auto denominator = [](ap_int<32> value) { return value_of(value, kDenominatorBits); };
  Eigen::Matrix3d m;
  m << numerator(map.xu), numerator(map.xv), numerator(map.x1),  //
      numerator(map.yu), numerator(map.yv), numerator(map.y1),   //
      denominator(map.zu), denominator(map.zv), denominator(map.z1);
  return m;
}

Eigen::Matrix3d unpack_homography(const ProjectiveMap& map, cv::Size image) {
  return from_middle(image).inverse() * unpack(map);
}

}  // namespace floorline
