#include "hls_stream.h"
#include <cstdio>
void standstill(hls::stream<int>& in, hls::stream<int>& out);
int main() {
  hls::stream<int> in, out;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 16; ++i) in.write(i);
    standstill(in, out);
    for (int i = 0; i < 16; ++i) if (out.read() != 0) return 1;
  }
  std::puts("ok");
  return 0;
}
