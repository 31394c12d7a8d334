// Streams that one function writes and reads: queues in memories, emptied and filled again.
// top: stream_queue
#include "hls_stream.h"
void stream_queue(const int in[24], int out[24]) {
  hls::stream<int> even, odd;
#pragma HLS STREAM variable=even depth=24
#pragma HLS STREAM variable=odd depth=24
  for (int round = 0; round < 2; ++round) {
    hls::stream<short, 12> again;
    for (int i = 0; i < 12; ++i) {
      if (in[12 * round + i] & 1)
        odd.write(in[12 * round + i]);
      else
        even.write(in[12 * round + i]);
      again.write(in[i]);
    }
    for (int i = 0; i < 3; ++i) odd.write(again.read());
  }
  int count = 0;
  while (!even.empty() && count < 24) out[count++] = even.read();
  while (!odd.empty() && count < 24) out[count++] = odd.read();
}
