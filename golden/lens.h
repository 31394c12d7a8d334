/// Golden twin of hls/lens.h: takes the distortion of the lens out of an image.
#ifndef FLOORLINE_GOLDEN_LENS_H
#define FLOORLINE_GOLDEN_LENS_H

#include <array>
#include <opencv2/core.hpp>

namespace floorline::golden {

enum class Interpolation { nearest, bilinear };

/// Rectification by the inverse map: for each pixel of the rectified image, whose camera matrix is that of
/// the camera itself, the place in the distorted image. Model of OpenCV: radial k1 k2 k3, tangential p1 p2.
class Lens {
 public:
  /// distortion: k1 k2 p1 p2 k3. The map is computed here, once, in double precision.
  Lens(const cv::Matx33d& camera_matrix, const std::array<double, 5>& distortion, cv::Size size,
       Interpolation interpolation);

  /// Where pixel (u, v) of the rectified image lies in the distorted one.
  cv::Point2d source(double u, double v) const;

  /// CV_8UC1 -> CV_8UC1 of the size given above. nearest: the pixel at floor(x + 0.5), floor(y + 0.5);
  /// bilinear: rounded to the nearest grey level. A pixel outside the image, also one of the four of a
  /// bilinear cell, reads 0.
  cv::Mat rectify(const cv::Mat& image) const;

  /// Largest |row of the source - row| over the image: the rows that the kernel's ring must hold on either
  /// side.
  int ring_radius() const;

 private:
  cv::Matx33d camera_matrix_;
  std::array<double, 5> distortion_;
  Interpolation interpolation_;
  cv::Mat map_;  ///< CV_64FC2: x, y in the distorted image.
};

}  // namespace floorline::golden

#endif
