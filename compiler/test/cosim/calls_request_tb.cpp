#include "hls_stream.h"

void calls_request(hls::stream<int>& in, hls::stream<int>& out);

int main() {
  hls::stream<int> in, out;
  for (int i = 0; i < 50; ++i) in.write(i * i);
  calls_request(in, out);
  for (int i = 0; i < 50; ++i) {
    if (out.empty()) return 1;
    if (out.read() != ((i * i + 1) * 3 + i) * i * i) return 1;
  }
  return 0;
}
