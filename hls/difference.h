/// What the ground homography does not explain: |H[I_n] - I_n+1| (ICVS paper, eq. 8).
///
/// plain: |nearest - current|. tolerant: how far `current` lies outside [low, high], the range of the 2x2
/// reference pixels around H(u, v), so that an error of less than a pixel in H leaves no edges behind.
/// 0 where the pair is not valid. Exact. No borders, no state. II = 1, width * height + depth cycles, depth
/// ~3.
#ifndef FLOORLINE_HLS_DIFFERENCE_H
#define FLOORLINE_HLS_DIFFERENCE_H

#include "hls_stream.h"
#include "raster.h"
#include "types.h"

namespace floorline {

/// Distance of `value` from the range [low, high].
inline Pixel distance_from_range(Pixel value, Pixel low, Pixel high) {
#pragma HLS INLINE
  if (value < low) return low - value;
  if (value > high) return value - high;
  return 0;
}

/// in: width * height pairs. out: as many differences.
template <int MAX_WIDTH, int MAX_HEIGHT>
void difference(hls::stream<PixelPair>& in, hls::stream<Pixel>& out, Size width, Size height,
                ap_uint<1> tolerant) {
PIXELS:
  for (RasterPosition at(width); at.v < height; at.advance()) {
#pragma HLS PIPELINE II = 1
#pragma HLS LOOP_TRIPCOUNT min = 1 max = MAX_WIDTH * MAX_HEIGHT
    const PixelPair pair = in.read();
    const Pixel low = tolerant ? pair.low : pair.nearest;
    const Pixel high = tolerant ? pair.high : pair.nearest;
    out.write(pair.valid ? distance_from_range(pair.current, low, high) : Pixel(0));
  }
}

}  // namespace floorline

#endif
