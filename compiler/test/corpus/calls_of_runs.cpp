// PIPELINE of the processes of a region: runs overlap in each of them, with their own scalars.
// top: calls_of_runs
// tokens: 1
// calls: 100
#include "hls_stream.h"
static void scale(hls::stream<int>& in, hls::stream<int>& out, int gain) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
  out.write(in.read() * gain);
}
static void add(hls::stream<int>& in, hls::stream<int>& out, int gain, short more) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
  out.write(in.read() * gain + more);
}
void calls_of_runs(hls::stream<int>& in, hls::stream<int>& out, int gain, short more) {
#pragma HLS DATAFLOW
  hls::stream<int> middle;
  scale(in, middle, gain);
  add(middle, out, gain + 1, more);
}
