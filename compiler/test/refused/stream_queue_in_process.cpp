#include "hls_stream.h"
void stream_queue_in_process(const int a[8], int b[8]) {
  hls::stream<int> queue;
  for (int i = 0; i < 8; ++i) queue.write(a[i]);
  for (int i = 0; i < 8; ++i) b[i] = queue.read();
}
// error: 4:37: stream 'queue' stays inside one process; put #pragma HLS DATAFLOW into the function that declares it and its writer and reader into functions of their own, or use an array
