// DATAFLOW in a loop: every iteration is a run of its processes, with a stream and an array between them.
// top: dataflow_loop
// range: rounds=0..5
#include "hls_stream.h"
static void load(const int in[64], hls::stream<int>& values, int round) {
  for (int i = 0; i < 8; ++i) values.write(in[(round * 8 + i) & 63]);
}
static void turn(hls::stream<int>& values, int turned[8], int add) {
  for (int i = 0; i < 8; ++i) turned[7 - i] = values.read() + add;
}
static void store(const int turned[8], int out[64], int round) {
  for (int i = 0; i < 8; ++i) out[round * 8 + i] = turned[i];
}
void dataflow_loop(const int in[64], int out[64], int rounds, int add) {
  for (int round = 0; round < rounds; ++round) {
#pragma HLS DATAFLOW
    hls::stream<int> values;
    int turned[8];
    load(in, values, round);
    turn(values, turned, add * round);
    store(turned, out, round);
  }
}
