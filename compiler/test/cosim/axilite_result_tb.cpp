#include "hls_stream.h"

int axilite_result(hls::stream<int>& in, hls::stream<int>& out, short count);

int main() {
  hls::stream<int> in, out;
  for (int call = 0; call < 10; ++call) {
    int expected = 0;
    for (int i = 0; i < call; ++i) {
      in.write(i * 7 - 3);
      expected += i * 7 - 3;
    }
    if (axilite_result(in, out, call) != expected) return 1;
    for (int i = 0; i < call; ++i)
      if (out.read() != (i * 7 - 3) * (i * 7 - 3)) return 1;
    if (!out.empty()) return 1;
  }
  return 0;
}
