// The condition under which a write happens tells that the read beside it is of another word: they need no order in an iteration.
// top: array_apart_by_condition
#include "ap_int.h"
#include "hls_stream.h"
void array_apart_by_condition(hls::stream<ap_uint<3> >& in, ap_uint<8> counts[8]) {
  for (int i = 0; i < 8; ++i) counts[i] = 0;
  ap_uint<3> last = 0;
  ap_uint<8> run = 0;
RUNS:
  for (int i = 0; i < 60; ++i) {  // expect: loop II=2
#pragma HLS PIPELINE II = 1
    const ap_uint<3> level = in.read();
    if (level == last) {
      run = run + 1;
    } else {
      counts[last] = run;
      run = counts[level] + 1;
    }
    last = level;
  }
  counts[last] = run;
}
