/// Golden twin of hls/polar.h: polar histogram, runs along lines from the focus, contact points.
#ifndef FLOORLINE_GOLDEN_POLAR_H
#define FLOORLINE_GOLDEN_POLAR_H

#include <vector>

#include "golden/binarize.h"
#include "golden/parameters.h"

namespace floorline::golden {

/// Where an obstacle touches the floor, in the image.
struct Contact {
  int line = 0;
  int u = 0;
  int v = 0;
  int rows = 0;          ///< Rows of the run (rule run) or S_c (rule paper).
  bool clipped = false;  ///< The run still went on where the line ends: the foot lies below.
  bool operator==(const Contact&) const = default;
};

/// What a line covers in one row: columns first to last in walk order (last < first for a line that runs
/// leftward).
struct Step {
  int row;
  int first_column;
  int last_column;
};

/// The rows of a line as cv::LineIterator walks it (8-connected), top to bottom, not clipped to any image.
std::vector<Step> walk(const Line& line);

struct PolarHistogram {
  std::vector<int> counts;        ///< Of each line: high pixels on it, inside the image.
  std::vector<Contact> contacts;  ///< In the order in which they are decided: by row, then by line.
};

/// Walks all lines over the masks; motion: CV_8UC1, what displacement() gives. a_r is eq. (17) around the
/// first column of the line's run in row r, S_c eq. (18), rules as in docs/architecture.md. Columns outside
/// the image read 0; when the first column lies outside, a_r is 0. Rows outside the image do not exist: a
/// line that goes on below ends in the last row.
PolarHistogram polar(const Masks& masks, const cv::Mat& motion, const std::vector<Line>& lines,
                     const RuleParameters& rule);

}  // namespace floorline::golden

#endif
