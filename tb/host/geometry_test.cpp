#include "host/geometry.h"

#include <limits>

#include "rig.h"
#include "test_files.h"

namespace floorline {
namespace {

const Camera camera = test_camera();
const Eigen::Isometry3d mount = robot_from_camera(test_angles);

TEST(GroundHomography, MapsAFloorPointBetweenTwoPoses) {
  const Eigen::Isometry3d reference_from_current = isometry({0.12, -0.03, 0.07});
  const Eigen::Matrix3d h = ground_homography(camera.matrix, mount, reference_from_current);
  for (const double x : {0.8, 1.5, 4.0}) {
    for (const double y : {-0.7, 0.0, 1.1}) {
      const Eigen::Vector3d point(x, y, 0);
      const Eigen::Vector2d now = pixel_of(camera, mount, point);
      const Eigen::Vector2d before = pixel_of(camera, mount, reference_from_current * point);
      EXPECT_LT((apply(h, now) - before).norm(), 1e-9);
    }
  }
}

TEST(GroundHomography, HoldsForAnyMotionOfTheRobot) {
  const Eigen::Isometry3d tilting = isometry({0.2, 0.1, 0.1}) * Eigen::Translation3d(0, 0, 0.02) *
                                    Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.6, 0.8, 0));
  const Eigen::Matrix3d h = ground_homography(camera.matrix, mount, tilting);
  const Eigen::Vector3d point(1.7, 0.4, 0);
  EXPECT_LT((apply(h, pixel_of(camera, mount, point)) - pixel_of(camera, mount, tilting * point)).norm(),
            1e-9);
}

TEST(GroundHomography, DoesNotHoldAboveTheFloor) {
  const Eigen::Isometry3d forward = isometry({0.2, 0, 0});
  const Eigen::Matrix3d h = ground_homography(camera.matrix, mount, forward);
  const Eigen::Vector3d point(1.5, 0, 0.3);
  EXPECT_GT((apply(h, pixel_of(camera, mount, point)) - pixel_of(camera, mount, forward * point)).norm(), 5);
}

TEST(FloorFromPixel, InvertsTheProjection) {
  const Eigen::Matrix3d floor = floor_from_pixel(camera.matrix, mount);
  for (const double x : {0.5, 2.0, 9.0}) {
    const Eigen::Vector2d pixel = pixel_of(camera, mount, {x, 0.3, 0});
    EXPECT_LT((apply(floor, pixel) - Eigen::Vector2d(x, 0.3)).norm(), 1e-9);
    EXPECT_GT(floor.row(2).dot(pixel.homogeneous()), 0) << "the denominator is positive below the horizon";
  }
}

TEST(FloorFromPixel, RefusesACameraThatIsNotAboveTheFloor) {
  EXPECT_REFUSED(floor_from_pixel(camera.matrix, robot_from_camera({.height_m = 0})), "not above the floor");
  Eigen::Matrix3d broken = camera.matrix;
  broken(0, 0) = NAN;
  EXPECT_REFUSED(floor_from_pixel(broken, mount), "not finite");
}

TEST(GroundHomography, RefusesOdometryThatIsNotFinite) {
  EXPECT_REFUSED(ground_homography(camera.matrix, mount, isometry({INFINITY, 0, 0})), "odometry");
}

TEST(Focus, IsTheLimitOfVerticalLines) {
  const Eigen::Vector2d point = focus(camera.matrix, mount).hnormalized();
  for (const double y : {-1.0, 0.5}) {
    const Eigen::Vector2d deep = pixel_of(camera, mount, {1.5, y, -1e9});
    EXPECT_LT((deep - point).norm(), 1e-5);
  }
}

TEST(Focus, LiesAtInfinityForALevelCamera) {
  const Eigen::Vector3d level = focus(camera.matrix, robot_from_camera({.height_m = 1}));
  EXPECT_EQ(level.z(), 0);
  EXPECT_GT(level.y(), 0) << "down the image";
}

TEST(HorizonRow, IsWhereFarFloorIsSeen) {
  for (const double y : {-3e8, 0.0, 3e8}) {
    const Eigen::Vector2d far = pixel_of(camera, mount, {1e9, y, 0});
    EXPECT_NEAR(horizon_row(camera.matrix, mount, far.x()), far.y(), 1e-5);
  }
}

TEST(HorizonRow, IsInfiniteForACameraThatLooksStraightDown) {
  const Eigen::Isometry3d down = robot_from_camera({.height_m = 1, .pitch_rad = M_PI / 2});
  EXPECT_LT(horizon_row(camera.matrix, down, 320), -1e6);
}

TEST(FloorInView, NeedsARowBelowTheHorizon) {
  EXPECT_NO_THROW(require_floor_in_view(camera, mount));
  EXPECT_NO_THROW(require_floor_in_view(camera, robot_from_camera({.height_m = 1, .pitch_rad = -0.4})));
  EXPECT_REFUSED(require_floor_in_view(camera, robot_from_camera({.height_m = 1, .pitch_rad = -0.6})),
                 "sees no floor");
}

TEST(ScaledAt, GivesADenominatorOfOne) {
  const Eigen::Matrix3d floor = floor_from_pixel(camera.matrix, mount);
  const Eigen::Vector2d pixel(319.5, 300);
  const Eigen::Matrix3d scaled = scaled_at(floor, pixel);
  EXPECT_NEAR(scaled.row(2).dot(pixel.homogeneous()), 1, 1e-12);
  EXPECT_LT((apply(scaled, pixel) - apply(floor, pixel)).norm(), 1e-12);
  EXPECT_REFUSED(scaled_at(Eigen::Matrix3d::Zero(), pixel), "singular");
}

}  // namespace
}  // namespace floorline
