/// Architecture 2 of the ICVS paper, "direct": image in, points on the floor out, one pixel a clock.
///
/// Every stage is a process of the DATAFLOW region and handles one frame a call. Cycles a frame: width *
/// height + width + a constant of the slowest process (the window filters), for frames back to back. From the
/// last pixel of the row that decides a contact to its floor point: one row a window filter, and what polar.h
/// and birdseye.h say.
#ifndef FLOORLINE_HLS_ACCELERATOR_H
#define FLOORLINE_HLS_ACCELERATOR_H

#include "binarize.h"
#include "birdseye.h"
#include "cluster.h"
#include "difference.h"
#include "displacement.h"
#include "duplicate.h"
#include "erode.h"
#include "frame_ring.h"
#include "gaussian.h"
#include "hls_stream.h"
#include "luma.h"
#include "otsu.h"
#include "parameters.h"
#include "polar.h"
#include "roi.h"
#include "types.h"

namespace floorline {

/// Maxima of a build. MARGIN: rows of the frame ring beyond a frame's; it bounds how far a replacing frame
/// may move.
template <int WIDTH, int HEIGHT, int RING_MARGIN, int LINES>
struct AcceleratorConfig {
  static const int MAX_WIDTH = WIDTH;
  static const int MAX_HEIGHT = HEIGHT;
  static const int MARGIN = RING_MARGIN;
  static const int MAX_LINES = LINES;
};

typedef AcceleratorConfig<640, 480, 32, 256> VgaConfig;
typedef AcceleratorConfig<1280, 384, 32, 256> WideConfig;  ///< KITTI-shaped frames.

/// One frame. pixels: width * height; points, obstacles and counts end with the frame's `end` element;
/// null_pixels: how many pixels of the frame have no counterpart in the reference; threshold_used: its high
/// threshold.
template <typename Config>
void accelerator(hls::stream<RgbPixel>& pixels, hls::stream<FloorPoint>& points,
                 hls::stream<Obstacle>& obstacles, hls::stream<LineCount>& counts,
                 hls::stream<ap_uint<24> >& null_pixels, hls::stream<Pixel>& threshold_used,
                 const FrameParameters& parameters, const LineSetup lines[Config::MAX_LINES]) {
#pragma HLS DATAFLOW
  const int WIDTH = Config::MAX_WIDTH;
  const int HEIGHT = Config::MAX_HEIGHT;
  const Size width = parameters.width;
  const Size height = parameters.height;

  // One pixel a clock on both sides: two places keep both sides from waiting for each other.
  hls::stream<Pixel> luma_out("luma_out");
  hls::stream<PixelPair> pairs("pairs");
  hls::stream<Pixel> difference_out("difference_out");
  hls::stream<Pixel> thresholds("thresholds");
  hls::stream<Mask> eroded("eroded");
  hls::stream<Mask> region("region");
#pragma HLS STREAM variable = luma_out depth = 2
#pragma HLS STREAM variable = pairs depth = 2
#pragma HLS STREAM variable = difference_out depth = 2
#pragma HLS STREAM variable = thresholds depth = 2
#pragma HLS STREAM variable = eroded depth = 2
#pragma HLS STREAM variable = region depth = 2
  hls::stream<Change> changes("changes");
#pragma HLS STREAM variable = changes depth = 2
  // Motions wait until their pixels have passed the window filters: two rows and their pipelines.
  hls::stream<Motion> motions("motions");
#pragma HLS STREAM variable = motions depth = 4096
  hls::stream<Pixel> blurred("blurred");
  hls::stream<Pixel> measured("measured");
  hls::stream<Mask> binary("binary");
#pragma HLS STREAM variable = blurred depth = 2
#pragma HLS STREAM variable = measured depth = 2
#pragma HLS STREAM variable = binary depth = 2
  // A wide obstacle ends on many lines in one row, a contact a clock, while birdseye takes three clocks each.
  hls::stream<Contact> contacts("contacts");
#pragma HLS STREAM variable = contacts depth = 64
  // Points are far apart: one place does.
  hls::stream<FloorPoint> floor_points("floor_points");
#pragma HLS STREAM variable = floor_points depth = 1
  // Points of the next frame's first rows, while cluster scans the lines of the frame before.
  hls::stream<FloorPoint> candidates("candidates");
#pragma HLS STREAM variable = candidates depth = 16

  luma<WIDTH, HEIGHT>(pixels, luma_out, width, height, parameters.grey);
  frame_ring<WIDTH, HEIGHT, Config::MARGIN>(luma_out, pairs, null_pixels, width, height,
                                            parameters.replace_reference, parameters.homography);
  difference<WIDTH, HEIGHT>(pairs, difference_out, changes, width, height);
  displacement<WIDTH, HEIGHT>(changes, motions, width, height, parameters.displacement);
  gaussian<WIDTH, HEIGHT>(difference_out, blurred, width, height);
  otsu<WIDTH, HEIGHT>(blurred, measured, thresholds, width, height);
  binarize<WIDTH, HEIGHT>(measured, thresholds, binary, threshold_used, width, height, parameters.threshold);
  erode<WIDTH, HEIGHT>(binary, eroded, width, height, parameters.erode_high);
  roi<WIDTH, HEIGHT>(eroded, region, width, height, parameters.roi_first_row, parameters.roi_last_row);
  polar<WIDTH, HEIGHT, Config::MAX_LINES>(region, motions, contacts, counts, width, height,
                                          parameters.line_count, parameters.rule, lines);
  birdseye(contacts, floor_points, parameters.birdseye);
  duplicate(floor_points, points, candidates);
  cluster<Config::MAX_LINES>(candidates, obstacles, parameters.line_count, parameters.cluster_gap,
                             parameters.rule.min_lines);
}

}  // namespace floorline

/// Tops for the HLS compilers, 256 lines each.
void floorline_accelerator(hls::stream<floorline::RgbPixel>& pixels,
                           hls::stream<floorline::FloorPoint>& points,
                           hls::stream<floorline::Obstacle>& obstacles,
                           hls::stream<floorline::LineCount>& counts, hls::stream<ap_uint<24> >& null_pixels,
                           hls::stream<floorline::Pixel>& threshold_used,
                           const floorline::FrameParameters& parameters,
                           const floorline::LineSetup lines[floorline::VgaConfig::MAX_LINES]);

void floorline_accelerator_wide(hls::stream<floorline::RgbPixel>& pixels,
                                hls::stream<floorline::FloorPoint>& points,
                                hls::stream<floorline::Obstacle>& obstacles,
                                hls::stream<floorline::LineCount>& counts,
                                hls::stream<ap_uint<24> >& null_pixels,
                                hls::stream<floorline::Pixel>& threshold_used,
                                const floorline::FrameParameters& parameters,
                                const floorline::LineSetup lines[floorline::WideConfig::MAX_LINES]);

#endif
