#include "hls_stream.h"

void calls_of_items(hls::stream<int>& in, hls::stream<int>& out);

// Bursts, the last ones of a single item, which must come out without another behind it. Co-simulation gives
// all items to the first call of a burst.
int main() {
  int sum = 0;
  for (int burst = 0; burst < 12; ++burst) {
    const int items = burst < 8 ? 20 : 1;
    hls::stream<int> in, out;
    for (int i = 0; i < items; ++i) in.write(burst + i);
    for (int i = 0; i < items; ++i) calls_of_items(in, out);
    for (int i = 0; i < items; ++i) {
      sum += (burst + i) * (burst + i);
      if (out.empty() || out.read() != sum) return 1;
    }
    if (!out.empty()) return 1;
  }
  return 0;
}
