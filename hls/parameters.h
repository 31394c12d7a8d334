/// Frame parameters: registers of the accelerator, taken at start of frame. Formats: docs/architecture.md.
#ifndef FLOORLINE_HLS_PARAMETERS_H
#define FLOORLINE_HLS_PARAMETERS_H

#include "types.h"

namespace floorline {

/// A projective map (u, v) -> (X / Z, Y / Z), row by row.
/// frame_ring: X, Y in Q14.18 pixels from the image's middle (width / 2, height / 2, rounded down), Z in
/// Q4.28. birdseye: X, Y in Q14.18 metres, Z in Q4.28.
struct ProjectiveMap {
  ap_int<32> xu, xv, x1;
  ap_int<32> yu, yv, y1;
  ap_int<32> zu, zv, z1;
};

/// The lens as lens.h takes it apart (model of OpenCV: radial k1 k2 k3, tangential p1 p2). Let fx, fy, cx, cy
/// be the camera matrix, x = (u - cx) / fx, y = (v - cy) / fy and s the greatest sqrt(x^2 + y^2) of the
/// image. Lengths are given in units of s, so that every lens uses the whole range of the formats.
struct LensParameters {
  ap_int<32> x_first, x_step;             ///< x / s in column 0 and from column to column, Q2.30.
  ap_int<32> y_first, y_step;             ///< y / s in row 0 and from row to row, Q2.30.
  ap_int<32> skew_first, skew_u, skew_v;  ///< 2 (p1 y + p2 x) at (0, 0), a column, a row, Q2.30.
  ap_int<25> radial1, radial2, radial3;   ///< k1 s^2, k2 s^4, k3 s^6, Q4.21.
  ap_int<18> centre_u, centre_v;          ///< cx, cy, Q12.6 pixels.
  ap_int<25> shift_u, shift_v;            ///< p2 fx s^2, p1 fy s^2, Q9.16 pixels.
};

/// How pixels become masks.
struct ThresholdParameters {
  Pixel floor;          ///< The high threshold is never below this.
  Pixel override_high;  ///< 0: use Otsu; else this value.
  Pixel low;            ///< Threshold of the low bit.
};

/// How far a pixel must have moved against the floor (displacement.h).
struct DisplacementParameters {
  Pixel noise;       ///< Grey levels that difference and gradient owe to the sensor; 255: motion unknown.
  ap_int<24> bound;  ///< Pixels that a still one may have moved in row 0, Q8.16.
  ap_int<24> bound_step;  ///< More of them a row further down, Q8.16.
};

/// How runs along a line become contact points.
struct RuleParameters {
  ap_uint<1> run_rule;  ///< 1: run rule (default), 0: the paper's triangle rule.
  Size min_rows;        ///< Least rows of a run.
  Size max_gap;         ///< Rows without a low pixel that a run survives.
  Coordinate horizon_row;
  ap_uint<10> height_ratio;  ///< Q2.8: least obstacle height over camera height.
  LineIndex min_lines;       ///< Least lines of an obstacle: 2 drops lone lines, mostly noise.
};

/// All that the host may change from frame to frame, but for the line table.
struct FrameParameters {
  Size width;
  Size height;
  ap_uint<1> grey;               ///< Input pixels are grey in their low byte.
  ap_uint<1> replace_reference;  ///< This frame becomes the reference of the next ones.
  ap_uint<1> erode_high;
  Size roi_first_row;
  Size roi_last_row;
  ap_uint<9> line_count;
  ap_uint<24> cluster_gap;   ///< Metres, Q8.16: points so near in x and y are one obstacle.
  ProjectiveMap homography;  ///< Current pixel -> reference pixel, from the image's middle.
  ProjectiveMap birdseye;    ///< Pixel -> floor metres in the robot frame.
  ThresholdParameters threshold;
  DisplacementParameters displacement;
  RuleParameters rule;
};

}  // namespace floorline

#endif
