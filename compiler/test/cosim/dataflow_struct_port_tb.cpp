#include <cstdio>

#include "dataflow_struct_port.h"
int main() {
  hls::stream<int> in;
  Block block;
  for (int call = 0; call < 3; ++call) {
    for (int i = 0; i < 16; ++i) in.write(i * 7 + call);
    dataflow_struct_port(in, block);
    for (int i = 0; i < 16; ++i)
      if (block.out[i / 4][i % 4] != (i * 7 + call) * 2 + i / 4) {
        std::printf("call %d, element %d: %d\n", call, i, block.out[i / 4][i % 4]);
        return 1;
      }
  }
  return 0;
}
