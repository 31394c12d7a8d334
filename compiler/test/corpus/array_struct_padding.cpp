// A history of structs with padding, shifted as a whole: the padding, an array in the struct, costs nothing.
// top: array_struct_padding
// expect: memory before_1 none
// expect: memory before registers count=3
#include "ap_int.h"
struct Neighbour {
  ap_uint<1> present;
  ap_int<17> x, y;
  ap_uint<9> obstacle;
};
void array_struct_padding(const int in[20], int out[20]) {
  Neighbour before[3];
  for (int i = 0; i < 3; ++i) {
#pragma HLS UNROLL
    before[i].present = 0;
    before[i].x = 0;
    before[i].y = 0;
    before[i].obstacle = 0;
  }
  for (int i = 0; i < 20; ++i) {
    Neighbour here = {(in[i] & 3) != 0, in[i], in[i] >> 3, i};
    for (int k = 2; k >= 0; --k)
      if (before[k].present && (before[k].x ^ here.y) & 1) here.obstacle = before[k].obstacle;
    out[i] = here.obstacle;
    for (int k = 2; k > 0; --k) {
#pragma HLS UNROLL
      before[k] = before[k - 1];
    }
    before[0] = here;
  }
}
