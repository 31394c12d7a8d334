#include "golden/frame_ring.h"

#include <algorithm>

#include "golden/parameters.h"

namespace floorline::golden {
namespace {

/// Fills row v of `pairs` from the reference; rows above `oldest_row` are lost.
void pair_row(PixelPairs& pairs, const cv::Mat& reference, const cv::Matx33d& h, int v, int oldest_row) {
  const int last_column = reference.cols - 1;
  const int last_row = reference.rows - 1;
  uchar* nearest = pairs.nearest.ptr(v);
  uchar* low = pairs.low.ptr(v);
  uchar* high = pairs.high.ptr(v);
  uchar* valid = pairs.valid.ptr(v);
  for (int u = 0; u <= last_column; ++u) {
    const double z = h(2, 0) * u + h(2, 1) * v + h(2, 2);
    if (!denominator_resolved(z)) continue;
    const double x = (h(0, 0) * u + h(0, 1) * v + h(0, 2)) / z;
    const double y = (h(1, 0) * u + h(1, 1) * v + h(1, 2)) / z;
    if (!(x >= -0.5 && x < last_column + 0.5 && y >= -0.5 && y < last_row + 0.5)) continue;
    const int left = std::max(cvFloor(x), 0);
    const int right = std::min(cvFloor(x) + 1, last_column);
    const int top = std::max(cvFloor(y), 0);
    const int bottom = std::min(cvFloor(y) + 1, last_row);
    if (top < oldest_row) continue;

    const uchar* upper = reference.ptr(top);
    const uchar* lower = reference.ptr(bottom);
    const auto [least, greatest] = std::minmax({upper[left], upper[right], lower[left], lower[right]});
    nearest[u] = reference.ptr(cvFloor(y + 0.5))[cvFloor(x + 0.5)];
    low[u] = least;
    high[u] = greatest;
    valid[u] = 255;
  }
}

}  // namespace

FrameRing::FrameRing(int ring_rows) : ring_rows_(ring_rows) {}

PixelPairs FrameRing::pair(const cv::Mat& current, const cv::Matx33d& homography, bool replace) {
  CV_Assert(current.type() == CV_8UC1 && current.rows <= ring_rows_);
  const auto black = [&] { return cv::Mat(cv::Mat::zeros(current.size(), CV_8UC1)); };
  PixelPairs pairs = {current, black(), black(), black(), black()};
  if (reference_.size() != current.size()) reference_.release();
  if (!reference_.empty()) {
    const int margin = ring_rows_ - current.rows;
    for (int v = 0; v < current.rows; ++v) {
      const int oldest_row = replace ? v - margin + 1 : 0;
      pair_row(pairs, reference_, homography, v, oldest_row);
    }
  }
  if (replace) reference_ = current.clone();
  return pairs;
}

}  // namespace floorline::golden
