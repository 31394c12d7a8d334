/// Packing of 3x3 matrices into the accelerator's fixed-point registers, with the error that this costs.
#ifndef FLOORLINE_HOST_FIXED_POINT_H
#define FLOORLINE_HOST_FIXED_POINT_H

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "hls/parameters.h"

namespace floorline {

/// Most that packing may move a mapped pixel of the frame.
inline constexpr double kHomographyErrorBound = 0.05;  // pixels
/// Most that packing may move a floor point no farther from the robot than kBirdseyeRange.
inline constexpr double kBirdseyeErrorBound = 0.01;  // metres
inline constexpr double kBirdseyeRange = 4.0;        // metres

/// A packed map and the greatest distance between what it and the matrix it came from say (pixels or metres).
struct PackedMap {
  ProjectiveMap map;
  double error;
};

/// Ground homography, current pixel -> reference pixel, packed as current pixel -> reference pixel from the
/// middle of the image. Scaled so that Z = 1 at the centre of `roi`; the
/// error is taken over all pixels of the ROI whose Z the accelerator accepts, (2^-4, 8), and that land in the
/// image. Throws Error for a non-finite or singular matrix, one that does not fit the format, and one beyond
/// the error bound.
PackedMap pack_homography(const Eigen::Matrix3d& reference_from_current, cv::Size image, cv::Rect roi);

/// Bird's eye, pixel -> floor metres in the robot frame; scale and errors as above, over the pixels of the
/// ROI with an accepted Z whose floor point lies within kBirdseyeRange.
PackedMap pack_birdseye(const Eigen::Matrix3d& floor_from_pixel, cv::Rect roi);

/// The matrix that a packed map stands for, Z = 1 at the centre of the ROI it was packed with.
Eigen::Matrix3d unpack(const ProjectiveMap& map);

/// The same for a ground homography, whose registers count from the middle of the image: current pixel ->
/// reference pixel.
Eigen::Matrix3d unpack_homography(const ProjectiveMap& map, cv::Size image);

}  // namespace floorline

#endif
