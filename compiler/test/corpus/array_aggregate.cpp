// AGGREGATE on a local array of structs: one memory, one word an element, also where a member is stored alone.
// top: array_aggregate
#include <ap_int.h>

struct Sample {
  ap_uint<5> weight;
  ap_int<9> value;
  bool seen;
};

int array_aggregate(const short in[48], ap_uint<4> forget) {
  static Sample samples[16];  // expect: memory samples ram 16x15
#pragma HLS AGGREGATE variable=samples
  for (int i = 0; i < 48; ++i) {
    const ap_uint<4> place = in[i];
    const Sample before = samples[place];
    const Sample after = {ap_uint<5>(before.weight + 1), before.seen ? ap_int<9>(before.value + in[i]) : ap_int<9>(in[i]), true};
    samples[place] = after;
  }
  Sample forgotten = samples[forget];
  forgotten.seen = false;
  samples[forget] = forgotten;
  int sum = 0;
  for (int i = 0; i < 16; ++i) {
    const Sample sample = samples[i];
    if (sample.seen) sum += sample.weight * sample.value;
  }
  return sum;
}
