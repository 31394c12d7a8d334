#include "golden/frame_ring.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "golden/parameters.h"

namespace floorline::golden {
namespace {

/// Steps of the interpolation in a pixel.
constexpr int steps = 64;

double interpolated(double a, double b, double place) { return a + (b - a) * place; }

/// The cell around a coordinate on one axis of `extent` pixels, clamped to the image.
struct AxisCell {
  int first;
  int second;
  double place;  ///< Of the coordinate from first to second: whole steps.
};

/// None when the pixel nearest to the coordinate lies outside the image.
std::optional<AxisCell> axis_cell(double coordinate, int extent) {
  const double rounded = std::floor(coordinate * steps + 0.5) / steps;
  if (!(rounded >= -0.5 && rounded < extent - 0.5)) return std::nullopt;
  const int below = cvFloor(rounded);
  return AxisCell{std::max(below, 0), std::min(below + 1, extent - 1), rounded - below};
}

/// Fills row v of `pairs` from the reference; rows above `oldest_row` are lost.
void pair_row(PixelPairs& pairs, const cv::Mat& reference, const cv::Matx33d& h, int v, int oldest_row) {
  for (int u = 0; u < reference.cols; ++u) {
    const double z = h(2, 0) * u + h(2, 1) * v + h(2, 2);
    if (!denominator_resolved(z)) continue;
    const auto column = axis_cell((h(0, 0) * u + h(0, 1) * v + h(0, 2)) / z, reference.cols);
    const auto row = axis_cell((h(1, 0) * u + h(1, 1) * v + h(1, 2)) / z, reference.rows);
    if (!column || !row || row->first < oldest_row) continue;

    const uchar* upper = reference.ptr(row->first);
    const uchar* lower = reference.ptr(row->second);
    const double above = interpolated(upper[column->first], upper[column->second], column->place);
    const double below = interpolated(lower[column->first], lower[column->second], column->place);
    pairs.reference.at<uchar>(v, u) = static_cast<uchar>(interpolated(above, below, row->place) + 0.5);
    pairs.gradient.at<uchar>(v, u) =
        static_cast<uchar>(std::max(std::abs(upper[column->first] - lower[column->second]),
                                    std::abs(upper[column->second] - lower[column->first])));
    pairs.valid.at<uchar>(v, u) = 255;
  }
}

}  // namespace

FrameRing::FrameRing(int ring_rows) : ring_rows_(ring_rows) {}

PixelPairs FrameRing::pair(const cv::Mat& current, const cv::Matx33d& homography, bool replace) {
  CV_Assert(current.type() == CV_8UC1 && current.rows <= ring_rows_);
  const auto black = [&] { return cv::Mat(cv::Mat::zeros(current.size(), CV_8UC1)); };
  PixelPairs pairs = {current, black(), black(), black()};
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
