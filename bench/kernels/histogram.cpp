/// The histogram of hls/histogram.h as a core of its own, to be compared with bench/handwritten: counts
/// the pixels of a frame while they pass and sends the counts of the 256 levels.
#include "histogram.h"

typedef floorline::HistogramTotals<640 * 480>::Count Count;

void histogram(hls::stream<floorline::Pixel>& in, hls::stream<floorline::Pixel>& out,
               hls::stream<Count>& counts, floorline::Size width, floorline::Size height) {
  using floorline::LEVELS;
  Count bins[LEVELS];
#pragma HLS RESOURCE variable = bins core = RAM_S2P_BRAM
CLEAR:
  for (int level = 0; level < LEVELS; ++level) {
#pragma HLS PIPELINE II = 1
    bins[level] = 0;
  }
  floorline::count_levels<640, 480>(in, out, bins, width, height);
SEND:
  for (int level = 0; level < LEVELS; ++level) {
#pragma HLS PIPELINE II = 1
    counts.write(bins[level]);
  }
}
