#include "hls_stream.h"
struct Block {
  int out[4][4];
};
void dataflow_struct_port(hls::stream<int>& in, Block& block);
