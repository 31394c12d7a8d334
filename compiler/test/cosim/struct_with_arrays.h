#include "ap_int.h"

struct Image {
  ap_uint<12> pixels[4][4];
  short gain;
};
struct Tap {
  int value;
  signed char weight;
};
struct Filter {
  int sum;
  Tap state[8];
};

void struct_with_arrays(const Image& in, Image& out, Filter* filter);
