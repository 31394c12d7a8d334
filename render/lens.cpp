#include "lens.h"

namespace floorline::render {
namespace {

using Eigen::Vector2d;

// OpenCV's model: normalised undistorted coordinates to distorted ones.
Vector2d distorted(const double (&k)[5], const Vector2d& p) {
  const double r2 = p.squaredNorm();
  const double radial = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
  const double xy = 2 * p.x() * p.y();
  return radial * p +
         Vector2d(k[2] * xy + k[3] * (r2 + 2 * p.x() * p.x()), k[2] * (r2 + 2 * p.y() * p.y()) + k[3] * xy);
}

// Fixed-point iteration, until it is far finer than a pixel.
Vector2d undistorted(const double (&k)[5], const Vector2d& p) {
  Vector2d guess = p;
  for (int i = 0; i < 20; ++i) {
    const Vector2d rest = p - distorted(k, guess);
    guess += rest;
    if (rest.squaredNorm() < 1e-14) break;
  }
  return guess;
}

Vector2d principal_point(const ImageFormat& image) {
  return {(image.width - 1) / 2.0, (image.height - 1) / 2.0};
}

}  // namespace

Eigen::Vector2f sample_offset(int i, int n) {
  float radical = 0, digit = 0.5f;
  for (int bits = i; bits; bits >>= 1, digit /= 2) radical += static_cast<float>(bits & 1) * digit;
  const float half_step = 0.5f / static_cast<float>(n);
  return {static_cast<float>(i) / static_cast<float>(n) + half_step - 0.5f, radical + half_step - 0.5f};
}

LensRays::LensRays(const ImageFormat& image, const Camera& camera) : image_(image), camera_(camera) {
  const Vector2d centre = principal_point(image);
  rays_.reserve(static_cast<std::size_t>(image.width) * image.height * image.samples);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      for (int s = 0; s < image.samples; ++s) {
        const Vector2d pixel = Vector2d(column, row) + sample_offset(s, image.samples).cast<double>();
        const Vector2d at = undistorted(camera.distortion, (pixel - centre) / camera.focal_px);
        rays_.emplace_back(at.cast<float>().x(), at.cast<float>().y(), 1.0f);
      }
    }
  }
}

bool LensRays::in_image(const Eigen::Vector3d& point) const {
  if (point.z() <= 0) return false;
  const Vector2d pixel =
      distorted(camera_.distortion, point.head<2>() / point.z()) * camera_.focal_px + principal_point(image_);
  return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < image_.width - 0.5 &&
         pixel.y() < image_.height - 0.5;
}

}  // namespace floorline::render
