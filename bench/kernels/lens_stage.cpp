/// The lens stage of hls/lens.h as a core of its own, for its resources: VGA, nearest pixel, rows that lie up
/// to 20 rows away.
#include "lens.h"

void lens_stage(hls::stream<floorline::Pixel>& in, hls::stream<floorline::Pixel>& out, floorline::Size width,
                floorline::Size height, const floorline::LensParameters& parameters) {
  floorline::lens<640, 480, 20, false>(in, out, width, height, parameters);
}
