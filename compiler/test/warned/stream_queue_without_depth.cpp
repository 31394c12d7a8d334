// A stream inside one process.
// top: stream_queue_without_depth
#include "hls_stream.h"
void stream_queue_without_depth(const int a[8], int b[8]) {
  hls::stream<int> queue;
  for (int i = 0; i < 8; ++i) queue.write(a[i]);
  for (int i = 0; i < 8; ++i) b[i] = queue.read();
}
// warning: 6:37: this stream is written and read by one process, as a queue in a memory of 1024 places; give it STREAM depth
