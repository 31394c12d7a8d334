/// Height, pitch and roll of a camera, found from images of a drive: the mount under which the floor moves as
/// the odometry says.
#ifndef FLOORLINE_HOST_MOUNT_FIT_H
#define FLOORLINE_HOST_MOUNT_FIT_H

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "host/camera.h"
#include "host/mount.h"

namespace floorline {

struct MountFit {
  MountAngles angles;
  double residual_before;  ///< Of the guess: mean difference of floor pixels, grey levels, each counted up to
                           ///< a cap.
  double residual;         ///< Of the result.
  int pairs;               ///< Pairs of frames that were compared.
};

/// Minimises the ground residual |H[I_n] - I_m| over pairs of frames with a baseline, coarse to fine,
/// starting from `guess`. It looks only at the corridor ahead that the robot drives through, 1.5 camera
/// heights to either side, and each pixel counts up to a cap, so that a few things that stand there do not
/// decide. frames: CV_8UC1, rectified; world_from_robot: a pose a frame. The guess must be good to some three
/// degrees and a tenth of the height. A fit that explains the images less well than the
/// guess is dropped for the guess. Roll shows least of the three in a narrow corridor. Throws Error when
/// the robot does not drive a quarter of the camera's height between frames of the sequence, or no floor is
/// in view.
MountFit fit_mount(const Camera& camera, const MountAngles& guess, const std::vector<cv::Mat>& frames,
                   const std::vector<Eigen::Isometry3d>& world_from_robot);

}  // namespace floorline

#endif
