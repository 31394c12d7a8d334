#include <cstdio>

#include "ap_int.h"
#include "hls_stream.h"
void finite_fifos(hls::stream<ap_uint<12> >& in, hls::stream<int>& out);
int main() {
  hls::stream<ap_uint<12> > in;
  hls::stream<int> out;
  for (int call = 0; call < 3; ++call) {
    int sum = 0;
    for (int i = 0; i < 32; ++i) {
      in.write(100 * i + call);
      sum += ap_uint<12>((100 * i + call) * (i % 2 ? 5 : 3));
    }
    finite_fifos(in, out);
    int difference = out.read(), told = out.read();
    if (difference != 0 || told != sum || !out.empty()) {
      std::printf("call %d: %d, %d instead of %d\n", call, difference, told, sum);
      return 1;
    }
  }
  return 0;
}
