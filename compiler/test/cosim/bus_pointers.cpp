// Pointers with m_axi and no depth, one of them between processes; a variable named by its address.
#include "hls_stream.h"

static void load(const int* from, int count, hls::stream<int>& to) {
  for (int i = 0; i < count; ++i) to.write(from[i]);
}

static void store(hls::stream<int>& from, int count, int* to) {
  int before[4] = {};
#pragma HLS DEPENDENCE variable=&before inter true distance=4
  for (int i = 0; i < count; ++i) {
    int value = from.read();
    to[i] = value - before[i % 4];
    before[i % 4] = value;
  }
}

extern "C" void bus_pointers(const int* from, int* to, int count) {
#pragma HLS INTERFACE m_axi port=from offset=slave bundle=gmem
#pragma HLS INTERFACE mode=m_axi port=to offset=slave bundle=gmem
#pragma HLS DATAFLOW
  hls::stream<int> values;
  load(from, count, values);
  store(values, count, to);
}
