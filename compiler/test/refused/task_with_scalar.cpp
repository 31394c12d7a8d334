#include "hls_task.h"
static void scale(hls::stream<int>& in, hls::stream<int>& out, int gain) { out.write(in.read() * gain); }
void task_with_scalar(hls::stream<int>& in, hls::stream<int>& out, int gain) {
  hls_thread_local hls::task scales(scale, in, out, gain);
}
// error: 4:30: task 'scale' takes more than streams; send the other values by streams
