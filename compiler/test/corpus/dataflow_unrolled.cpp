// Processes of an unrolled loop: rows of an array between them, a nested dataflow function with a stream of its own.
// top: dataflow_unrolled
#include "hls_stream.h"
static void stage(const int in[8], int out[8], int add) {
  for (int i = 0; i < 8; ++i) out[i] = in[7 - i] + add;
}
static void feed(const int in[8], hls::stream<int> out[2]) {
  for (int i = 0; i < 8; ++i) out[i & 1].write(in[i]);
}
static void scale(hls::stream<int>& in, hls::stream<int>& out, int by) {
  for (int i = 0; i < 4; ++i) out.write(in.read() * by);
}
static void lane(hls::stream<int>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<int> middle;
  scale(in, middle, 3);
  scale(middle, out, -5);
}
static void collect(hls::stream<int> in[2], int out[8]) {
  for (int i = 0; i < 8; ++i) out[i] = in[i & 1].read();
}
void dataflow_unrolled(const int in[8], int out[8]) {
#pragma HLS DATAFLOW
  int rows[3][8];
#pragma HLS ARRAY_PARTITION variable = rows complete dim = 1
  hls::stream<int> from[2], to[2];
  stage(in, rows[0], 1);
  for (int i = 1; i < 3; ++i) {
#pragma HLS UNROLL
    stage(rows[i - 1], rows[i], 10 * i);
  }
  feed(rows[2], from);
  for (int i = 0; i < 2; ++i) {
#pragma HLS UNROLL
    lane(from[i], to[i]);
  }
  collect(to, out);
}
