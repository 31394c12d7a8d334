// Elements dealt to four tasks and collected again, in turn and as they come.
#include "hls_np_channel.h"

constexpr int kWorkers = 4;

static void send(const int in[32], hls::stream<int>& out) {
  for (int i = 0; i < 32; ++i) out.write(in[i]);
}

static void work(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read() * 2 + 5); }

static void receive(hls::stream<int>& in, int out[32]) {
  for (int i = 0; i < 32; ++i) out[i] = in.read();
}

void tasks_split_merge(const int in[32], int ordered[32], const int more[32], int any_order[32]) {
#pragma HLS DATAFLOW
  hls_thread_local hls::split::round_robin<int, kWorkers> split;
  hls_thread_local hls::merge::round_robin<int, kWorkers> merge;
  hls_thread_local hls::split::load_balance<int, kWorkers> balanced_split;
  hls_thread_local hls::merge::load_balance<int, kWorkers> balanced_merge;
  hls_thread_local hls::task workers[kWorkers], balanced_workers[kWorkers];
  send(in, split.in);
  send(more, balanced_split.in);
  for (int i = 0; i < kWorkers; ++i) {
#pragma HLS UNROLL
    workers[i](work, split.out[i], merge.in[i]);
    balanced_workers[i](work, balanced_split.out[i], balanced_merge.in[i]);
  }
  receive(merge.out, ordered);
  receive(balanced_merge.out, any_order);
}
