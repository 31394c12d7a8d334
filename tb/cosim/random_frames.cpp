#include "tb/cosim/random_frames.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "host/error.h"
#include "host/line_table.h"

namespace floorline::cosim {
namespace {

constexpr int kLeastSide = 16;
constexpr double kPixel = 1 << 18;  ///< X and Y of a projective map.
constexpr double kUnit = 1 << 28;   ///< Its Z.

ap_int<32> fixed(double value, double one) { return static_cast<int>(std::lround(value * one)); }

}  // namespace

cv::Size RandomFrames::size(cv::Size largest) {
  return {number(kLeastSide, largest.width), number(kLeastSide, largest.height)};
}

cv::Mat RandomFrames::image(cv::Size size) {
  cv::Mat image(size, chance(0.5) ? CV_8UC1 : CV_8UC3, cv::Scalar::all(number(0, 255)));
  for (int shape = number(0, 4); shape > 0; --shape) {
    const cv::Rect box(number(-8, size.width), number(-8, size.height), number(1, size.width),
                       number(1, size.height));
    cv::rectangle(image, box, cv::Scalar(number(0, 255), number(0, 255), number(0, 255)), cv::FILLED);
  }
  cv::Mat noise(size, image.type());
  random_.fill(noise, cv::RNG::UNIFORM, 0, chance(0.2) ? 256 : number(1, 24));
  return image + noise;
}

/// Mostly near the identity; now and then far from it, where Z leaves its range and nothing is valid.
ProjectiveMap RandomFrames::homography(cv::Size size) {
  const auto near = [&](double value, double spread) { return value + random_.uniform(-spread, spread); };
  const double spread = chance(0.1) ? 1.0 : 0.02;
  ProjectiveMap map;
  map.xu = fixed(near(1, spread), kPixel);
  map.xv = fixed(near(0, spread), kPixel);
  map.x1 = fixed(near(0, spread * size.width), kPixel);
  map.yu = fixed(near(0, spread), kPixel);
  map.yv = fixed(near(1, spread), kPixel);
  map.y1 = fixed(near(0, spread * size.height), kPixel);
  map.zu = fixed(near(0, spread / size.width), kUnit);
  map.zv = fixed(near(0, spread / size.height), kUnit);
  map.z1 = fixed(near(1, spread), kUnit);
  return map;
}

/// Over a hall, or over the metre before the robot, where neighbouring lines meet on one obstacle.
ProjectiveMap RandomFrames::birdseye(cv::Size size) {
  const auto draw = [&](double limit) { return random_.uniform(-limit, limit); };
  const double metres = chance(0.5) ? 8 : 0.5;
  ProjectiveMap map;
  map.xu = fixed(draw(0.5 * metres / size.width), kPixel);
  map.xv = fixed(draw(0.5 * metres / size.height), kPixel);
  map.x1 = fixed(draw(metres), kPixel);
  map.yu = fixed(draw(0.5 * metres / size.width), kPixel);
  map.yv = fixed(draw(0.5 * metres / size.height), kPixel);
  map.y1 = fixed(draw(metres), kPixel);
  map.zu = fixed(draw(1.0 / size.width), kUnit);
  map.zv = fixed(draw(1.0 / size.height), kUnit);
  map.z1 = fixed(random_.uniform(0.0, 4.0), kUnit);
  return map;
}

FrameParameters RandomFrames::parameters(cv::Size size) {
  FrameParameters p = {};
  p.replace_reference = chance(0.6);
  p.erode_high = chance(0.5);
  const int first = number(0, size.height - 1), last = number(0, size.height - 1);
  p.roi_first_row = chance(0.5) ? 0 : std::min(first, last);
  p.roi_last_row = chance(0.5) ? size.height - 1 : std::max(first, last);
  p.cluster_gap = number(0, 1 << number(1, 24));
  p.homography = homography(size);
  p.birdseye = birdseye(size);
  p.threshold.floor = number(0, 40);
  p.threshold.override_high = chance(0.5) ? 0 : number(1, 120);
  p.threshold.low = number(0, 40);
  p.displacement.noise = chance(0.3) ? 255 : number(0, 8);
  p.displacement.bound = number(-(1 << 17), 1 << 20);
  p.displacement.bound_step = number(-(1 << 10), 1 << 12);
  p.rule.run_rule = chance(0.7);
  p.rule.min_rows = number(0, 12);
  p.rule.max_gap = number(0, 6);
  p.rule.horizon_row = number(-size.height, size.height);
  p.rule.height_ratio = chance(0.5) ? 0 : number(0, 200);
  p.rule.min_lines = number(0, 4);
  return p;
}

std::vector<LineSetup> RandomFrames::lines(cv::Size size) {
  constexpr int kLessThanWidth = 16;  // the polar engine's rule
  constexpr int kMostLines = 256;
  const int most = std::min(kMostLines, size.width - kLessThanWidth);
  if (most < 1 || chance(0.05)) return {};
  while (true) {
    LineBeam beam;
    beam.focus = {random_.uniform(-1.0, 2.0) * size.width, random_.uniform(-1.0, 6.0) * size.height,
                  chance(0.8) ? 1.0 : -1.0};
    beam.image = size;
    beam.roi_first_row = number(0, size.height / 2);
    beam.roi_last_row = number(beam.roi_first_row, size.height - 1);
    beam.line_count = number(1, most);
    try {
      return line_table(beam_lines(beam), size);
    } catch (const Error&) {
      // A beam that the host refuses; the next one.
    }
  }
}

}  // namespace floorline::cosim
