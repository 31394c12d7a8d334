/// Region of interest: masks outside rows [first_row, last_row] become 0. Above the horizon there is no
/// floor, and the homography says nothing there.
///
/// first_row > last_row: nothing passes. Exact. II = 1, width * height + depth cycles, depth ~2.
#ifndef FLOORLINE_HLS_ROI_H
#define FLOORLINE_HLS_ROI_H

#include "hls_stream.h"
#include "raster.h"

namespace floorline {

/// in: width * height masks. out: as many.
template <int MAX_WIDTH, int MAX_HEIGHT>
void roi(hls::stream<Mask>& in, hls::stream<Mask>& out, Size width, Size height, Size first_row,
         Size last_row) {
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
    const Mask mask = in.read();
    out.write(first_row <= at.v && at.v <= last_row ? mask : Mask(0));
  }
}

}  // namespace floorline

#endif
