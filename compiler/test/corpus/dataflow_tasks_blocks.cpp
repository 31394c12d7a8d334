// Tasks with a stream of blocks between them.
// top: dataflow_tasks_blocks
#include "hls_streamofblocks.h"
#include "hls_task.h"
typedef short Line[16];
static void collect(hls::stream<short>& in, hls::stream_of_blocks<Line>& lines) {
  hls::write_lock<Line> line(lines);
  for (int i = 0; i < 16; ++i) line[i] = in.read();
}
static void reverse(hls::stream_of_blocks<Line>& lines, hls::stream<short>& out) {
  hls::read_lock<Line> line(lines);
  for (int i = 15; i >= 0; --i) out.write(line[i]);
}
void dataflow_tasks_blocks(hls::stream<short>& in, hls::stream<short>& out) {
  hls_thread_local hls::stream_of_blocks<Line> lines;
  hls_thread_local hls::task first(collect, in, lines);
  hls_thread_local hls::task second(reverse, lines, out);
}
