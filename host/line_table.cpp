#include "host/line_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "host/error.h"

namespace floorline {
namespace {

constexpr int kFarthestColumn = 2047;
constexpr int kMostLines = 256;
constexpr int kSlack = 16;  // polar_engine::LINE_SLACK: columns of a row without a line step.

/// The walk before its fields are packed: plain integers, rows may lie above the image.
struct Walk {
  int column, row, run, error;
  int slice, remainder, divisor, direction;

  void step() {
    error += remainder;
    const int carry = error >= divisor ? 1 : 0;
    error -= carry * divisor;
    column += direction * (slice == 0 ? carry : run);
    run = slice == 0 ? 1 : slice + carry;
    ++row;
  }
};

/// cv::LineIterator steps its minor axis at ceil(i * minor / major - 1/2): ends of the runs of a shallow line
/// lie at floor((2 y + 1) dx / 2 dy), columns of a steep one at floor((2 i dx + dy - 1) / 2 dy). Both halves
/// of the numerator are kept as one integer error, since every increment is even.
Walk walk_of(cv::Point top, cv::Point bottom) {
  const int dx = std::abs(bottom.x - top.x);
  const int dy = bottom.y - top.y;
  const int direction = bottom.x < top.x ? -1 : 1;
  if (dy == 0) return {top.x, top.y, dx + 1, 0, 0, 0, 1, direction};
  if (dy > dx) return {top.x, top.y, 1, (dy - 1) / 2, 0, dx, dy, direction};
  return {top.x, top.y, dx / (2 * dy) + 1, dx % (2 * dy) / 2, dx / dy, dx % dy, dy, direction};
}

/// A ray from the focus side, clipped to the pixel centres of the ROI (Liang-Barsky). False when it misses.
bool clip_to(const cv::Rect2d& roi, cv::Point2d& a, cv::Point2d& b) {
  const cv::Point2d d = b - a;
  double first = 0.0, last = 1.0;
  const auto cut = [&](double slope, double room) {
    if (slope == 0.0) return room >= 0.0;
    const double t = room / slope;
    if (slope < 0.0) first = std::max(first, t);
    if (slope > 0.0) last = std::min(last, t);
    return first <= last;
  };
  const bool meets = cut(-d.x, a.x - roi.x) && cut(d.x, roi.x + roi.width - a.x) && cut(-d.y, a.y - roi.y) &&
                     cut(d.y, roi.y + roi.height - a.y);
  if (!meets) return false;
  b = a + last * d;
  a = a + first * d;
  return true;
}

using Segment = std::pair<cv::Point2d, cv::Point2d>;

/// Column where the line through `point` and the focus meets `row`.
double column_at(const Eigen::Vector3d& focus, cv::Point2d point, double row) {
  // Direction from the point to the focus, times w: finite for a focus at infinity too.
  const double du = focus.x() - focus.z() * point.x;
  const double dv = focus.y() - focus.z() * point.y;
  return point.x + du / dv * (row - point.y);
}

/// First and last column along the first ROI row of the lines that cover the ROI.
std::pair<double, double> fan_span(const LineBeam& beam, const cv::Rect2d& roi) {
  const double last_row = roi.y + roi.height;
  const double right = roi.x + roi.width;
  return {std::min(roi.x, column_at(beam.focus, {roi.x, last_row}, roi.y)),
          std::max(right, column_at(beam.focus, {right, last_row}, roi.y))};
}

double share_of(int i, int count) { return count == 1 ? 0.5 : double(i) / (count - 1); }

std::vector<Segment> fan(const LineBeam& beam, const cv::Rect2d& roi) {
  const auto [first, last] = fan_span(beam, roi);
  const double last_row = roi.y + roi.height;
  std::vector<Segment> segments;
  for (int i = 0; i < beam.line_count; ++i) {
    const cv::Point2d top(std::lerp(first, last, share_of(i, beam.line_count)), roi.y);
    segments.emplace_back(top, cv::Point2d(column_at(beam.focus, top, last_row), last_row));
  }
  return segments;
}

/// Bearings are 0 downwards and grow clockwise on the screen.
double bearing_of(cv::Point2d d) { return std::atan2(-d.x, d.y); }

std::vector<Segment> star(const LineBeam& beam, const cv::Rect2d& roi) {
  const cv::Point2d focus(beam.focus.x() / beam.focus.z(), beam.focus.y() / beam.focus.z());
  const double reach = roi.width + roi.height + std::abs(focus.x) + std::abs(focus.y);
  const bool inside =
      focus.x >= roi.x && focus.x <= roi.x + roi.width && focus.y >= roi.y && focus.y <= roi.y + roi.height;
  double first = 0.0, span = 2.0 * std::numbers::pi;
  if (!inside) {
    const cv::Point2d to_centre = cv::Point2d(roi.x + roi.width / 2.0, roi.y + roi.height / 2.0) - focus;
    double least = 0.0, greatest = 0.0;
    for (const cv::Point2d corner :
         {roi.tl(), roi.br(), {roi.x, roi.y + roi.height}, {roi.x + roi.width, roi.y}}) {
      const double offset =
          std::remainder(bearing_of(corner - focus) - bearing_of(to_centre), 2.0 * std::numbers::pi);
      least = std::min(least, offset);
      greatest = std::max(greatest, offset);
    }
    first = bearing_of(to_centre) + least;
    span = greatest - least;
  }
  std::vector<Segment> segments;
  for (int i = 0; i < beam.line_count; ++i) {
    // Half a step off the seam, so that the first and the last line of a full circle differ.
    const double share = inside ? (i + 0.5) / beam.line_count : share_of(i, beam.line_count);
    const double bearing = first + share * span;
    segments.emplace_back(focus, focus + reach * cv::Point2d(-std::sin(bearing), std::cos(bearing)));
  }
  return segments;
}

/// Whether lines are spread by bearing around the focus: it lies within the ROI's rows, or so near that
/// spreading them along the first row would take most of them out of the image.
bool star_shaped(const LineBeam& beam, const cv::Rect2d& roi) {
  const double w = beam.focus.z();
  if (w == 0.0) return false;
  const double above = beam.focus.y() - w * roi.y;
  const double below = beam.focus.y() - w * (roi.y + roi.height);
  if (above * below <= 0.0) return true;
  const auto [first, last] = fan_span(beam, roi);
  return last - first > 2.0 * beam.image.width;
}

void refuse(const LineBeam& beam) {
  if (beam.line_count < 0 || beam.line_count > kMostLines) {
    throw Error("The line table takes 0 to " + std::to_string(kMostLines) + " lines, not " +
                std::to_string(beam.line_count) + ".");
  }
  if (beam.line_count > 0 && beam.line_count + kSlack > beam.image.width) {
    throw Error(std::to_string(beam.line_count) + " lines cannot keep up with rows of " +
                std::to_string(beam.image.width) + " pixels: use at most " +
                std::to_string(std::max(0, beam.image.width - kSlack)) + " lines.");
  }
  if (beam.roi_first_row < 0 || beam.roi_first_row > beam.roi_last_row ||
      beam.roi_last_row >= beam.image.height) {
    throw Error("The ROI rows " + std::to_string(beam.roi_first_row) + " to " +
                std::to_string(beam.roi_last_row) + " must be in order and within the image's " +
                std::to_string(beam.image.height) + " rows.");
  }
  if (!beam.focus.allFinite() || beam.focus.isZero()) {
    throw Error("The focus of the lines is not a point: check the calibration and the mount.");
  }
  if (beam.focus.y() == 0.0 && beam.focus.z() == 0.0) {
    throw Error(
        "The lines would be horizontal, as of a camera that lies on its side: turn the mount by 90 degrees.");
  }
}

}  // namespace

std::vector<BeamLine> beam_lines(const LineBeam& beam) {
  refuse(beam);
  const cv::Rect2d roi(0.0, beam.roi_first_row, beam.image.width - 1.0,
                       beam.roi_last_row - beam.roi_first_row);
  const double w = beam.focus.z();
  std::vector<BeamLine> lines;
  for (auto [a, b] : star_shaped(beam, roi) ? star(beam, roi) : fan(beam, roi)) {
    if (!clip_to(roi, a, b)) {
      // Rounding at a corner: the line touches the ROI in one pixel.
      a = b = {std::clamp(a.x, roi.x, roi.x + roi.width), std::clamp(a.y, roi.y, roi.y + roi.height)};
    }
    const bool leads_away = w > 0.0 && beam.focus.y() < w * (a.y + b.y) / 2.0;
    if (a.y > b.y) std::swap(a, b);
    lines.push_back({a, b, leads_away});
  }
  return lines;
}

LineSetup line_setup(const BeamLine& ends, cv::Size image) {
  const cv::Point top = ends.first, bottom = ends.last;
  if (top.y > bottom.y) throw Error("A line is walked from top to bottom: exchange its end points.");
  if (std::max(std::abs(top.x), std::abs(bottom.x)) > kFarthestColumn || bottom.y - top.y > kFarthestColumn) {
    throw Error("A line may reach at most 2047 columns and rows: move its end points nearer to the image.");
  }
  if (bottom.y < 0 || top.y >= image.height)
    throw Error("A line has no row in the image: leave it out of the table.");

  Walk walk = walk_of(top, bottom);
  while (walk.row < 0) walk.step();
  LineSetup line = {};
  line.first_column = walk.column;
  line.first_row = walk.row;
  line.first_error = walk.error;
  line.first_run = walk.run;
  line.slice = walk.slice;
  line.remainder = walk.remainder;
  line.divisor = walk.divisor;
  line.leftward = walk.direction < 0;
  line.contact_first = ends.contact_first;
  const int last_row = std::min(bottom.y, image.height - 1);
  while (walk.row < last_row) walk.step();
  line.last_row = last_row;
  line.last_run = last_row == bottom.y ? std::abs(bottom.x - walk.column) + 1 : walk.run;
  if (line.first_row == line.last_row) line.first_run = line.last_run;
  return line;
}

std::vector<LineSetup> line_table(const std::vector<BeamLine>& lines, cv::Size image) {
  std::vector<LineSetup> setups;
  for (const BeamLine& line : lines) setups.push_back(line_setup(line, image));
  return setups;
}

std::vector<cv::Point> line_pixels(const LineSetup& line) {
  const int direction = line.leftward ? -1 : 1;
  Walk walk = {
      line.first_column.to_int(), line.first_row.to_int(), line.first_run.to_int(), line.first_error.to_int(),
      line.slice.to_int(),        line.remainder.to_int(), line.divisor.to_int(),   direction};
  std::vector<cv::Point> pixels;
  while (walk.row <= line.last_row.to_int()) {
    const int run = walk.row == line.last_row.to_int() ? line.last_run.to_int() : walk.run;
    for (int i = 0; i < run; ++i) pixels.emplace_back(walk.column + direction * i, walk.row);
    walk.step();
  }
  return pixels;
}

}  // namespace floorline
