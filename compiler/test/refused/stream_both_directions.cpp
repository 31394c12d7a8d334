#include "hls_stream.h"
void stream_both_directions(hls::stream<int>& s) {
  for (int i = 0; i < 8; ++i) s.write(s.read() + 1);
}
