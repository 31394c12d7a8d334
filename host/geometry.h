/// Plane geometry of a camera above a floor (ICVS paper, eq. 1-8 and 14-16). Robot frame: Z = 0 is the floor.
#ifndef FLOORLINE_HOST_GEOMETRY_H
#define FLOORLINE_HOST_GEOMETRY_H

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "host/camera.h"

namespace floorline {

/// Pixel of a point in the camera frame; z must be positive.
Eigen::Vector2d project(const Eigen::Matrix3d& camera_matrix, const Eigen::Vector3d& point);

/// H1 of eq. (4): floor (X, Y, 1) in the robot frame, metres -> pixel.
Eigen::Matrix3d pixel_from_floor(const Eigen::Matrix3d& camera_matrix,
                                 const Eigen::Isometry3d& robot_from_camera);

/// eq. (14)-(15) in metres: pixel -> floor (X, Y, 1) in the robot frame, scaled so that the denominator is
/// positive below the horizon. Throws Error when the camera is not above the floor or a number is not finite.
Eigen::Matrix3d floor_from_pixel(const Eigen::Matrix3d& camera_matrix,
                                 const Eigen::Isometry3d& robot_from_camera);

/// Inverse of eq. (8): pixel of the current frame -> pixel of the reference frame, for points on the floor of
/// the current robot frame. reference_from_current: pose of the robot now, seen from where it was. Throws
/// Error like floor_from_pixel.
Eigen::Matrix3d ground_homography(const Eigen::Matrix3d& camera_matrix,
                                  const Eigen::Isometry3d& robot_from_camera,
                                  const Eigen::Isometry3d& reference_from_current);

/// eq. (16): vanishing point of vertical lines, homogeneous, K times the downward direction. w > 0: the nadir
/// lies in front of the camera; w = 0: level camera.
Eigen::Vector3d focus(const Eigen::Matrix3d& camera_matrix, const Eigen::Isometry3d& robot_from_camera);

/// Row of the horizon at column u; infinite for a camera that looks straight down. Floor lies below it.
double horizon_row(const Eigen::Matrix3d& camera_matrix, const Eigen::Isometry3d& robot_from_camera,
                   double u);

/// Throws Error when no pixel of the image's last row sees the floor.
void require_floor_in_view(const Camera& camera, const Eigen::Isometry3d& robot_from_camera);

/// The same projective map with a denominator of 1 at `pixel`. Throws Error when it is 0 there or a number is
/// not finite.
Eigen::Matrix3d scaled_at(const Eigen::Matrix3d& map, const Eigen::Vector2d& pixel);

/// Applies a projective map.
Eigen::Vector2d apply(const Eigen::Matrix3d& map, const Eigen::Vector2d& point);

}  // namespace floorline

#endif
