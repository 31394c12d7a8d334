#include "hls_task.h"
static void add(hls::stream<int>& in, hls::stream<int>& out) { out.write(in.read() + 1); }
void tasks_with_start(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_hs port = return
  hls_thread_local hls::task adds(add, in, out);
}
// error: 3:6: tasks alone neither start nor end, so there is nothing for 'ap_ctrl_hs' to tell; write ap_ctrl_none, or nothing, for port=return
