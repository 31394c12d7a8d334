// A struct with an array, a parameter of a DATAFLOW top that a process fills.
#include "dataflow_struct_port.h"
static void twice(hls::stream<int>& in, hls::stream<int>& out) {
  for (int i = 0; i < 16; ++i) out.write(in.read() * 2);
}
static void fill(hls::stream<int>& in, Block& block) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) block.out[i][j] = in.read() + i;
}
void dataflow_struct_port(hls::stream<int>& in, Block& block) {
#pragma HLS DATAFLOW
  hls::stream<int> between;
  twice(in, between);
  fill(between, block);
}
