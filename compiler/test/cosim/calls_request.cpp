// A process whose calls overlap waits in each for an answer to what the call has asked.
#include "hls_task.h"
static void front(hls::stream<int>& in, hls::stream<int>& ask, hls::stream<int>& answer, hls::stream<int>& out) {
#pragma HLS PIPELINE II=1
  const int x = in.read();
  ask.write(x + 1);
  out.write(answer.read() * x);
}
static void back(hls::stream<int>& ask, hls::stream<int>& answer) {
#pragma HLS PIPELINE II=1
  static int count = 0;
  answer.write(ask.read() * 3 + count++);
}
void calls_request(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS INTERFACE ap_ctrl_none port=return
  hls_thread_local hls::stream<int> ask, answer;
  hls_thread_local hls::task fronts(front, in, ask, answer, out);
  hls_thread_local hls::task backs(back, ask, answer);
}
