/// Golden twin of hls/frame_ring.h: holds the reference frame and finds each current pixel's counterpart in
/// it.
#ifndef FLOORLINE_GOLDEN_FRAME_RING_H
#define FLOORLINE_GOLDEN_FRAME_RING_H

#include <opencv2/core.hpp>

namespace floorline::golden {

/// A frame of pixel pairs: CV_8UC1 images of one size. Where `valid` is 0, reference and gradient are 0 too.
struct PixelPairs {
  cv::Mat current;
  cv::Mat reference;  ///< Interpolated at H(u, v), a coordinate rounded to 64ths of a pixel.
  cv::Mat gradient;   ///< Greater difference across a diagonal of the 2x2 cell there, clamped to the image.
  cv::Mat valid;      ///< 255 or 0.
};

/// A reference frame in a ring of a fixed number of rows. A frame that replaces the reference is written into
/// the ring while the old reference is read, so that row v overwrites row v - (ring_rows - height) of it:
/// that row and those above are lost to row v and the rows below.
class FrameRing {
 public:
  /// ring_rows: at least the height of every frame.
  explicit FrameRing(int ring_rows);

  /// Pairs `current` (CV_8UC1) with the reference. `homography` maps current pixel centres to reference
  /// pixels, x = X / Z, y = Y / Z, and is scaled as the accelerator's (Z near 1). Valid: Z within the bounds
  /// above, -0.5 <= x < width - 0.5 for the rounded x, the same for y, and both rows of the cell still in the
  /// ring. Nothing is valid before a frame has replaced the reference; a frame of another size drops the
  /// reference. With `replace` the frame becomes the reference of the next.
  PixelPairs pair(const cv::Mat& current, const cv::Matx33d& homography, bool replace);

 private:
  int ring_rows_;
  cv::Mat reference_;
};

}  // namespace floorline::golden

#endif
