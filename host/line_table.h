/// Line tables: the beam of Bresenham lines through the focus (ICVS paper, section 2.4) as the polar engine
/// walks it.
#ifndef FLOORLINE_HOST_LINE_TABLE_H
#define FLOORLINE_HOST_LINE_TABLE_H

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "hls/types.h"

namespace floorline {

/// The part of the image that lines cover, and how many.
struct LineBeam {
  /// Vertical vanishing point, homogeneous: K * (down direction in the camera frame), eq. (16), sign kept. w
  /// > 0: the nadir is in front of the camera; w < 0: the point is the zenith's; w = 0: level camera,
  /// parallel lines.
  Eigen::Vector3d focus;
  cv::Size image;
  int roi_first_row;
  int roi_last_row;
  int line_count;
};

/// A line by its end points, walked from the upper one, `first`, to `last`. golden::Line is its twin in
/// the golden model, so that the table for the hardware does not lean on it; Configuration copies one to the
/// other.
struct BeamLine {
  cv::Point first;
  cv::Point last;
  bool
      contact_first;  ///< The line leads away from the nadir: an obstacle's foot is the first row of its run.
};

/// Lines of the beam, neighbours by bearing, cut to the ROI.
/// Focus above or below the ROI (or at infinity): spaced equally along the first ROI row, as in the paper,
/// over the span whose lines cover the whole ROI. Focus within the ROI's rows, or so near that this span
/// would exceed two image widths: spaced by equal angles over the bearings under which the focus sees the
/// ROI, the full circle when it lies in the ROI; the seam (line 0, last line) then points straight down.
/// Throws Error for a beam that the polar engine cannot walk: line_count + 16 > width, more than 256 lines,
/// an empty ROI, no focus.
std::vector<BeamLine> beam_lines(const LineBeam& beam);

/// Setup of a line whose pixels are those of cv::LineIterator(first, last), 8-connected, cut to the rows of
/// the image; columns may lie outside it, up to 2047 columns and rows. Throws Error when no row of the line
/// lies in the image, when its end points are upside down, or out of range.
LineSetup line_setup(const BeamLine& line, cv::Size image);

/// Setups of all lines.
std::vector<LineSetup> line_table(const std::vector<BeamLine>& lines, cv::Size image);

/// The pixels that the polar engine visits for a line, in the order of its walk (columns outside the image
/// included).
std::vector<cv::Point> line_pixels(const LineSetup& line);

}  // namespace floorline

#endif
