// The accelerator for frames of up to 128x64 and 32 lines, small enough to be simulated as gates
// (scripts/gate_level.sh).
#include "accelerator.h"

void floorline_accelerator_small(
    hls::stream<floorline::RgbPixel>& pixels, hls::stream<floorline::FloorPoint>& points,
    hls::stream<floorline::Obstacle>& obstacles, hls::stream<floorline::LineCount>& counts,
    hls::stream<ap_uint<24> >& null_pixels, hls::stream<floorline::Pixel>& threshold_used,
    const floorline::FrameParameters& parameters, const floorline::LineSetup lines[32]) {
#pragma HLS INTERFACE axis port = pixels
#pragma HLS INTERFACE axis port = points
#pragma HLS INTERFACE axis port = obstacles
#pragma HLS INTERFACE axis port = counts
#pragma HLS INTERFACE axis port = null_pixels
#pragma HLS INTERFACE axis port = threshold_used
#pragma HLS INTERFACE ap_none port = parameters
#pragma HLS INTERFACE ap_memory port = lines
#pragma HLS INTERFACE ap_ctrl_hs port = return
#pragma HLS DATAFLOW
  floorline::accelerator<floorline::AcceleratorConfig<128, 64, 2, 32> >(
      pixels, points, obstacles, counts, null_pixels, threshold_used, parameters, lines);
}
