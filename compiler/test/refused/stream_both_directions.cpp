#include "hls_stream.h"
void stream_both_directions(hls::stream<int>& s) {
  for (int i = 0; i < 8; ++i) s.write(s.read() + 1);
}
// error: 3:33: stream 's' is both read and written by one process; use a local array, or split the process
