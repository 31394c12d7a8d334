#include "accelerator.h"

void floorline_accelerator(hls::stream<floorline::RgbPixel>& pixels,
                           hls::stream<floorline::FloorPoint>& points,
                           hls::stream<floorline::Obstacle>& obstacles,
                           hls::stream<floorline::LineCount>& counts, hls::stream<ap_uint<24> >& null_pixels,
                           hls::stream<floorline::Pixel>& threshold_used,
                           const floorline::FrameParameters& parameters,
                           const floorline::LineSetup lines[floorline::VgaConfig::MAX_LINES]) {
#pragma HLS INTERFACE axis port = pixels
#pragma HLS INTERFACE axis register_mode = forward port = points
#pragma HLS INTERFACE axis register_mode = forward port = obstacles
#pragma HLS INTERFACE axis port = counts
#pragma HLS INTERFACE axis register_mode = forward port = null_pixels
#pragma HLS INTERFACE axis register_mode = forward port = threshold_used
#pragma HLS INTERFACE ap_none port = parameters
#pragma HLS INTERFACE ap_memory port = lines
#pragma HLS INTERFACE ap_ctrl_hs port = return
#pragma HLS DATAFLOW
  floorline::accelerator<floorline::VgaConfig>(pixels, points, obstacles, counts, null_pixels, threshold_used,
                                               parameters, lines);
}

void floorline_accelerator_wide(hls::stream<floorline::RgbPixel>& pixels,
                                hls::stream<floorline::FloorPoint>& points,
                                hls::stream<floorline::Obstacle>& obstacles,
                                hls::stream<floorline::LineCount>& counts,
                                hls::stream<ap_uint<24> >& null_pixels,
                                hls::stream<floorline::Pixel>& threshold_used,
                                const floorline::FrameParameters& parameters,
                                const floorline::LineSetup lines[floorline::WideConfig::MAX_LINES]) {
#pragma HLS INTERFACE axis port = pixels
#pragma HLS INTERFACE axis register_mode = forward port = points
#pragma HLS INTERFACE axis register_mode = forward port = obstacles
#pragma HLS INTERFACE axis port = counts
#pragma HLS INTERFACE axis register_mode = forward port = null_pixels
#pragma HLS INTERFACE axis register_mode = forward port = threshold_used
#pragma HLS INTERFACE ap_none port = parameters
#pragma HLS INTERFACE ap_memory port = lines
#pragma HLS INTERFACE ap_ctrl_hs port = return
#pragma HLS DATAFLOW
  floorline::accelerator<floorline::WideConfig>(pixels, points, obstacles, counts, null_pixels,
                                                threshold_used, parameters, lines);
}
