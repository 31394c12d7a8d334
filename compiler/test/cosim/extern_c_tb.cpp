#include "ap_int.h"
#include "hls_stream.h"

struct Bits {
  ap_uint<3> low;
  ap_int<5> high;
};
extern "C" int extern_c(int name, int eval, int reg[4], Bits input, int& output, bool clk, int final_,
                        hls::stream<int>& begin, int ap_start_);

int main() {
  for (int call = 1; call < 5; ++call) {
    hls::stream<int> begin;
    for (int i = 0; i < 4; ++i) begin.write(i * call);
    Bits input;
    input.low = call;
    input.high = -call;
    int reg[4], output = 0;
    if (extern_c(17 + call, 100, reg, input, output, call & 1, 7, begin, 10) != call + 10) return 1;
    if (reg[3] != 3 * call + 1 + call) return 1;
    if (output != 6 * call + 4 * (1 + call) + (call & 1 ? 7 : 100)) return 1;
  }
  return 0;
}
