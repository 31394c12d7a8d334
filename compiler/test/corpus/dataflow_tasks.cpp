// hls::task: each task starts again for itself, however often the others run.
// top: dataflow_tasks
// calls: 3
#include "hls_task.h"
static void split(hls::stream<int>& in, hls::stream<int>& odd, hls::stream<int>& even) {
  int value = in.read();
  if (value & 1)
    odd.write(value);
  else
    even.write(value);
}
static void add(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read() + 1); }
static void twice(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read() * 2); }
void dataflow_tasks(hls::stream<int>& in, hls::stream<int>& odd, hls::stream<int>& even) {
  hls_thread_local hls::stream<int> to_add;
  hls_thread_local hls::stream<int, 4> to_twice;
  hls_thread_local hls::task splits(split, in, to_add, to_twice);
  hls_thread_local hls::task adds(add, to_add, odd);
  hls_thread_local hls::task doubles(twice, to_twice, even);
}
