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

ProjectiveMap translation(cv::Size size, double x, double y) {
  ProjectiveMap map = {};
  map.xu = map.yv = fixed(1, kPixel);
  map.x1 = fixed(x - size.width / 2, kPixel);
  map.y1 = fixed(y - size.height / 2, kPixel);
  map.z1 = fixed(1, kUnit);
  return map;
}

}  // namespace

void RandomFrames::begin_scene(cv::Size size) {
  constexpr Scene kScenes[] = {Scene::unrelated, Scene::floor, Scene::contacts, Scene::contacts,
                               Scene::splits};
  scene_ = kScenes[number(0, 4)];
  size_ = size;
  lines_ = lines(size);
  first_ = true;
}

FrameInput RandomFrames::next() {
  FrameInput input;
  switch (scene_) {
    case Scene::unrelated:
      input = {image(size_), parameters(size_), {}};
      break;
    case Scene::floor:
      input = floor_frame();
      break;
    case Scene::contacts:
      input = contacts_frame();
      break;
    case Scene::splits:
      input = splits_frame();
      break;
  }
  if (first_) input.parameters.replace_reference = 1;
  first_ = false;
  input.lines = lines_;
  return input;
}

FrameInput RandomFrames::floor_frame() {
  constexpr int kMargin = 24;
  if (first_) {
    texture_.create(size_ + cv::Size(2 * kMargin, 2 * kMargin), CV_8UC1);
    random_.fill(texture_, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(texture_, texture_, {}, random_.uniform(0.5, 3.0));
    cv::normalize(texture_, texture_, number(0, 100), number(120, 255), cv::NORM_MINMAX);
    offset_ = {kMargin, kMargin};
  }
  offset_.x = std::clamp(offset_.x + number(-3, 3), 0, 2 * kMargin);
  offset_.y = std::clamp(offset_.y + number(-2, 2), 0, 2 * kMargin);
  cv::Mat image = texture_(cv::Rect(offset_, size_)).clone();
  for (int box = number(0, 3); box > 0; --box) {
    const cv::Rect place =
        cv::Rect(point(), cv::Size(number(1, size_.width), number(1, size_.height))) & cv::Rect({}, size_);
    random_.fill(image(place), cv::RNG::UNIFORM, number(0, 200), 256);
  }

  FrameParameters p = parameters(size_);
  const cv::Point moved = first_ ? cv::Point() : offset_ - reference_offset_;
  const double error = chance(0.5) ? 0 : 0.6;
  p.homography =
      translation(size_, moved.x + random_.uniform(-error, error), moved.y + random_.uniform(-error, error));
  p.threshold.low = number(0, 15);
  p.displacement.noise = number(0, 4);
  p.displacement.bound = number(0, 1 << 17);
  p.displacement.bound_step = number(-64, 64);
  if (first_ || p.replace_reference) reference_offset_ = offset_;
  return {image, p, {}};
}

FrameInput RandomFrames::contacts_frame() {
  cv::Mat image = cv::Mat::zeros(size_, CV_8UC1);
  if (!first_) {
    // Teeth of a comb leave lines without contacts between others.
    const int period = number(8, 40), tooth = chance(0.5) ? period : number(1, period);
    for (int bar = number(1, 8); bar > 0; --bar) {
      cv::rectangle(image, cv::Rect(point(), cv::Size(number(1, size_.width), number(1, 10))),
                    cv::Scalar(number(20, 255)), cv::FILLED);
    }
    for (int u = 0; u < size_.width; ++u) {
      if (u % period >= tooth) image.col(u).setTo(0);
    }
    for (int speck = number(0, 40); speck > 0; --speck) {
      const cv::Point at = point();  // A third of them near the left or the right border.
      const int border = number(0, 8),
                column = std::clamp(border < 4 ? border : size_.width + 3 - border, 0, size_.width - 1);
      image.at<uchar>(at.y, chance(0.33) ? column : at.x) = 255;
    }
  }

  FrameParameters p = parameters(size_);
  p.replace_reference = 0;
  p.erode_high = chance(0.2);
  if (chance(0.8)) p.roi_first_row = 0, p.roi_last_row = size_.height - 1;
  p.cluster_gap = number(0, 1 << number(11, 17));
  p.homography = translation(size_, 0, 0);
  p.threshold.floor = number(0, 20);
  p.threshold.override_high = chance(0.5) ? 0 : number(1, 60);
  p.threshold.low = number(0, 60);  // From 33 on a speck's Gaussian is a single pixel.
  if (chance(0.7)) p.displacement.noise = 255;
  p.rule.min_rows = number(0, 3);
  p.rule.max_gap = number(0, 3);
  if (chance(0.8)) p.rule.height_ratio = 0;
  p.rule.min_lines = number(0, 2);
  return {image, p, {}};
}

FrameInput RandomFrames::splits_frame() {
  FrameParameters p = parameters(size_);
  p.replace_reference = 0;
  p.homography = translation(size_, 0, 0);
  p.threshold.floor = chance(0.7) ? 0 : number(0, 255);
  p.threshold.override_high = 0;
  return {first_ ? cv::Mat::zeros(size_, CV_8UC1) : split_image(), p, {}};
}

cv::Mat RandomFrames::split_image() {
  cv::Mat image(size_, CV_8UC1);
  switch (number(0, 3)) {
    case 0:  // No split, and the ends of the scale.
      image.setTo(chance(0.5) ? 255 * number(0, 1) : number(0, 255));
      if (chance(0.5)) image.at<uchar>(point()) = static_cast<uchar>(number(0, 255));
      break;
    case 1:  // Two levels.
      image.setTo(number(0, 255));
      cv::rectangle(image, cv::Rect(point(), point()), cv::Scalar(number(0, 255)), cv::FILLED);
      break;
    case 2: {  // Equal classes at equal distances.
      const int classes = number(2, 6), step = number(1, 255 / classes),
                first = number(0, 255 - step * (classes - 1));
      for (int u = 0; u < size_.width; ++u) image.col(u).setTo(first + step * (u * classes / size_.width));
      break;
    }
    default: {  // Symmetric about a level: every split has a twin.
      const int middle = number(1, 127);
      random_.fill(image, cv::RNG::UNIFORM, 0, 2 * middle + 1);
      if (chance(0.5)) cv::GaussianBlur(image, image, {}, 1.5);
      cv::Mat left = image.colRange(0, size_.width / 2), mirrored;
      cv::flip(left, mirrored, 1);
      cv::Mat(cv::Scalar(2 * middle) - mirrored).copyTo(image.colRange(size_.width - left.cols, size_.width));
      if (chance(0.5)) image.at<uchar>(point()) = static_cast<uchar>(number(0, 255));
    }
  }
  return image;
}

cv::Size RandomFrames::size(cv::Size largest) {
  return {number(kLeastSide, largest.width), number(kLeastSide, largest.height)};
}

/// What luma weighs, every R - G and B - G in turn.
cv::Mat RandomFrames::colour_differences(cv::Size size) {
  constexpr int kMost = 255, kCount = 2 * kMost + 1;
  cv::Mat image(size, CV_8UC3);
  int place = number(0, kCount * kCount - 1);
  for (cv::Vec3b& pixel : cv::Mat_<cv::Vec3b>(image)) {
    place = (place + 1) % (kCount * kCount);
    const int red = place % kCount - kMost, blue = place / kCount - kMost;
    const int green = (kMost - std::max({0, red, blue}) - std::min({0, red, blue})) / 2;
    pixel = {cv::saturate_cast<uchar>(green + blue), cv::saturate_cast<uchar>(green),
             cv::saturate_cast<uchar>(green + red)};
  }
  return image;
}

cv::Mat RandomFrames::image(cv::Size size) {
  if (chance(0.2)) return colour_differences(size);
  cv::Mat image(size, chance(0.5) ? CV_8UC1 : CV_8UC3, cv::Scalar::all(number(0, 255)));
  for (int shape = number(0, 4); shape > 0; --shape) {
    const cv::Rect box(number(-8, size.width), number(-8, size.height), number(1, size.width),
                       number(1, size.height));
    cv::rectangle(image, box, cv::Scalar(number(0, 255), number(0, 255), number(0, 255)), cv::FILLED);
  }
  cv::Mat noise(size, image.type());
  random_.fill(noise, cv::RNG::UNIFORM, 0, chance(0.5) ? 256 : number(1, 24));
  return image + noise;
}

/// Mostly near the identity; now and then far from it, where Z leaves its range and nothing is valid.
ProjectiveMap RandomFrames::homography(cv::Size size) {
  const auto near = [&](double value, double spread) { return value + random_.uniform(-spread, spread); };
  const double spread = chance(0.1) ? 1.0 : 0.02;
  ProjectiveMap map;
  map.xu = fixed(near(1, spread), kPixel);
  map.xv = fixed(near(0, spread), kPixel);
  map.x1 = fixed(near(-size.width / 2, spread * size.width), kPixel);
  map.yu = fixed(near(0, spread), kPixel);
  map.yv = fixed(near(1, spread), kPixel);
  map.y1 = fixed(near(-size.height / 2, spread * size.height), kPixel);
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

/// Lines whose ends may lie outside the image, at its sides and below it.
std::vector<LineSetup> RandomFrames::crossing_lines(cv::Size size, int count) {
  const auto column = [&] { return number(-size.width / 2, 3 * size.width / 2); };
  std::vector<BeamLine> lines;
  for (int i = 0; i < count; ++i) {
    const int row = number(0, size.height - 1);
    lines.push_back({{column(), row}, {column(), number(row, 5 * size.height / 4)}, chance(0.5)});
  }
  return line_table(lines, size);
}

std::vector<LineSetup> RandomFrames::lines(cv::Size size) {
  constexpr int kLessThanWidth = 16;  // the polar engine's rule
  constexpr int kMostLines = 256;
  const int most = std::min(kMostLines, size.width - kLessThanWidth);
  if (most < 1 || chance(0.05)) return {};
  if (chance(0.3)) return crossing_lines(size, number(1, most));
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
