#include "host/fixed_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>

#include "host/error.h"

namespace floorline {
namespace {

using testing::HasSubstr;

const cv::Size kImage(640, 480);
const cv::Rect kRoi(0, 160, 640, 320);

/// Pixel -> floor of a camera `height` metres above the floor, pitched down: the rays of a pinhole meet the
/// plane.
Eigen::Matrix3d floor_from_pixel(double height, double pitch) {
  const double f = 500.0, c = std::cos(pitch), s = std::sin(pitch);
  Eigen::Matrix3d k;
  k << f, 0, 319.5, 0, f, 239.5, 0, 0, 1;
  Eigen::Matrix3d
      ray_to_floor;  // ray (right, down, forward) -> (X, Y, Z) with x = X / Z forward, y = Y / Z left
  ray_to_floor << 0, -s * height, c * height, -height, 0, 0, 0, c, s;
  return ray_to_floor * k.inverse();
}

TEST(PackBirdseye, KeepsTheFloorWithinACentimetre) {
  const PackedMap packed = pack_birdseye(floor_from_pixel(0.4, 0.35), kRoi);
  EXPECT_GT(packed.error, 0.0);
  EXPECT_LE(packed.error, kBirdseyeErrorBound);
  const Eigen::Vector3d pixel(400, 450, 1);
  const Eigen::Vector2d exact = (floor_from_pixel(0.4, 0.35) * pixel).hnormalized();
  EXPECT_LE(((unpack(packed.map) * pixel).hnormalized() - exact).norm(), packed.error);
}

TEST(PackBirdseye, DoesNotDependOnTheScaleOrSignOfTheMatrix) {
  const Eigen::Matrix3d m = floor_from_pixel(0.4, 0.35);
  EXPECT_EQ(unpack(pack_birdseye(m, kRoi).map), unpack(pack_birdseye(-8.0 * m, kRoi).map));
}

TEST(PackHomography, KeepsPixelsWithinABoundOverRandomMotions) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> metres(-0.1, 0.1), radians(-0.05, 0.05);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Matrix3d to_floor = floor_from_pixel(0.4, 0.35);
    const double yaw = radians(random);
    Eigen::Matrix3d motion;
    motion << std::cos(yaw), -std::sin(yaw), metres(random), std::sin(yaw), std::cos(yaw), metres(random), 0,
        0, 1;
    const PackedMap packed = pack_homography(to_floor.inverse() * motion * to_floor, kImage, kRoi);
    EXPECT_LE(packed.error, kHomographyErrorBound);
    const Eigen::Vector3d centre(319.5, 319.5, 1);
    EXPECT_NEAR((unpack(packed.map) * centre).z(), 1.0, 1e-8);
  }
}

std::string homography_message(const Eigen::Matrix3d& m) {
  try {
    pack_homography(m, kImage, kRoi);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PackHomography, RefusesWhatIsNoMap) {
  EXPECT_EQ(homography_message(Eigen::Matrix3d::Identity()), "");
  EXPECT_THAT(homography_message(Eigen::Matrix3d::Zero()), HasSubstr("singular"));
  EXPECT_THAT(homography_message(Eigen::Matrix3d::Ones()), HasSubstr("singular"));
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(homography_message(m), HasSubstr("no number"));
  m = Eigen::Matrix3d::Identity();
  m.row(2) << 0, 1, -319.5;
  EXPECT_THAT(homography_message(m), HasSubstr("horizon"));
}

TEST(PackHomography, RefusesWhatDoesNotFit) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m(0, 2) = 8192.0 + kImage.width / 2;
  EXPECT_THAT(homography_message(m), HasSubstr("does not fit"));
}

TEST(PackBirdseye, RefusesAnErrorBeyondTheBound) {
  // The same lens on an image three times as wide: roundings of the slopes add up over 1000 columns.
  try {
    pack_birdseye(floor_from_pixel(0.02, 0.1), {0, 160, 2047, 320});
    FAIL() << "must be refused";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("costs"));
  }
}

}  // namespace
}  // namespace floorline
