// A C++ top with C linkage; arguments are called as the handshake, as members of Verilator's class, as words
// of Verilog; types and functions as in the co-simulation's own sources.
#include "ap_int.h"
#include "hls_stream.h"

struct Bits {
  ap_uint<3> low;
  ap_int<5> high;
};
static int slice(int x) { return x & 15; }
static int cycle_count;

extern "C" {
int extern_c(int name, int eval, int reg[4], Bits input, int& output, bool clk, int final_,
             hls::stream<int>& begin, int ap_start_) {
  ++cycle_count;
  int initial = 0;
  for (int always = 0; always < 4; ++always) {
    reg[always] = begin.read() + slice(name);
    initial += reg[always];
  }
  output = initial + input.low + input.high + (clk ? final_ : eval);
  return cycle_count + ap_start_;
}
}
