// Streams of an array chosen by a subscript at run time, to read and to write.
// top: stream_array_dynamic
// tokens: 64
#include "hls_stream.h"
void stream_array_dynamic(hls::stream<int> in[3], hls::stream<int> out[4], int first) {
LOOP:
  for (int i = 0; i < 12; ++i) {
#pragma HLS PIPELINE II = 1
    int from = (i + (first & 1)) % 3;
    int value = in[from].read();
    if (value & 1) out[(value >> 1) & 3].write(value + i);
  }
}
