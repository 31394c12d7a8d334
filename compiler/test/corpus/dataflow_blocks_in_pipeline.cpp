// A pipelined loop that locks a block an iteration: accesses stay between its locks.
// top: dataflow_blocks_in_pipeline
// range: blocks=1..9
#include "hls_stream.h"
#include "hls_streamofblocks.h"
typedef int Four[4];
static void pack(hls::stream<int>& in, hls::stream_of_blocks<Four>& blocks, int count) {
  for (int i = 0; i < count; ++i) {
#pragma HLS PIPELINE
    hls::write_lock<Four> block(blocks);
    for (int j = 0; j < 4; ++j) block[j] = in.read();
    if (i & 1) block[2] = i;
  }
}
static void add(hls::stream_of_blocks<Four>& blocks, hls::stream<int>& out, int count) {
  int last = 0;
  for (int i = 0; i < count; ++i) {
#pragma HLS PIPELINE
    Four& block = blocks.read_acquire();
    out.write(block[0] + 3 * block[1] + 5 * block[2] + 7 * block[3] + last);
    last = block[0];
    blocks.read_release();
  }
}
void dataflow_blocks_in_pipeline(hls::stream<int>& in, hls::stream<int>& out, int blocks) {
#pragma HLS DATAFLOW
  static hls::stream_of_blocks<Four> four;
  pack(in, four, blocks);
  add(four, out, blocks);
}
