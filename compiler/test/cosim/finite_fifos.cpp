// What C simulation with finite FIFOs has to run side by side: streams in arrays, with a depth in their type, static
// ones; an array and a scalar that one process sets for the next; a DATAFLOW function in another; polling.
#include "ap_int.h"
#include "hls_stream.h"
typedef ap_uint<12> Value;
static void deal(hls::stream<Value>& in, hls::stream<Value> lanes[2]) {
  for (int i = 0; i < 32; ++i) lanes[i % 2].write(in.read());
}
template <int K>
static void scale(hls::stream<Value>& in, hls::stream<Value>& out) {
  for (int i = 0; i < 16; ++i) out.write(in.read() * K);
}
static void inner(hls::stream<Value>& in, hls::stream<Value>& out) {
#pragma HLS DATAFLOW
  hls::stream<Value, 3> between;
  scale<3>(in, between);
  scale<1>(between, out);
}
static void gather(hls::stream<Value>& a, hls::stream<Value>& b, Value table[32], int& sum) {
  int count = 0, total = 0;
  while (count < 32) {
    Value v;
    if (a.read_nb(v) || b.read_nb(v)) {
      table[count++] = v;
      total += v;
    }
  }
  sum = total;
}
static void finish(const Value table[32], int sum, hls::stream<int>& out) {
  int total = 0;
  for (int i = 0; i < 32; ++i) total += table[i];
  out.write(total - sum);
  out.write(sum);
}
void finite_fifos(hls::stream<Value>& in, hls::stream<int>& out) {
#pragma HLS DATAFLOW
  hls::stream<Value> lanes[2];
#pragma HLS STREAM variable=lanes depth=1
  static hls::stream<Value> left, right;
  Value table[32];
  int sum;
  deal(in, lanes);
  inner(lanes[0], left);
  scale<5>(lanes[1], right);
  gather(left, right, table, sum);
  finish(table, sum, out);
}
