/// What the ground homography does not explain: |H[I_n] - I_n+1| (ICVS paper, eq. 8).
///
/// |reference - current|, 0 where the pair is not valid. Exact. No borders, no state. II = 1, width * height
/// + depth cycles, depth ~3.
#ifndef FLOORLINE_HLS_DIFFERENCE_H
#define FLOORLINE_HLS_DIFFERENCE_H

#include "hls_stream.h"
#include "raster.h"
#include "types.h"

namespace floorline {

/// in: width * height pairs. out: as many differences; changes: the same with the gradients of the reference.
template <int MAX_WIDTH, int MAX_HEIGHT>
void difference(hls::stream<PixelPair>& in, hls::stream<Pixel>& out, hls::stream<Change>& changes, Size width,
                Size height) {
PIXELS:
  for (RasterPosition<MAX_WIDTH, MAX_HEIGHT> at(width, height); at.inside; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
    const PixelPair pair = in.read();
    const Pixel changed = pair.valid ? distance(pair.current, pair.reference) : Pixel(0);
    out.write(changed);
    const Change change = {changed, pair.gradient};
    changes.write(change);
  }
}

}  // namespace floorline

#endif
