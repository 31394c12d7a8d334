// Tasks between two processes of a DATAFLOW function that starts and ends.
#include "hls_task.h"

static void deal(const int in[32], int count, hls::stream<int> out[4]) {
  for (int i = 0; i < count; ++i) out[i % 4].write(in[i]);
}

static void work(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read() * 3 + 1); }

static void collect(hls::stream<int> in[4], int out[32], int count) {
  for (int i = 0; i < count; ++i) out[i] = in[i % 4].read();
}

void tasks_between(const int in[32], int out[32], int count) {
#pragma HLS DATAFLOW
  hls_thread_local hls::stream<int, 4> dealt[4], done[4];
  hls_thread_local hls::task workers[4];
  deal(in, count, dealt);
  for (int i = 0; i < 4; ++i) {
#pragma HLS UNROLL
    workers[i](work, dealt[i], done[i]);
  }
  collect(done, out, count);
}
