// Pointers to volatile ap_uint and ap_int.
#include "volatile_numbers.h"

void volatile_numbers(volatile ap_uint<20>* in, volatile ap_int<9>* out) {
#pragma HLS INTERFACE ap_memory port = in depth = 16
#pragma HLS INTERFACE ap_memory port = out depth = 16
  ap_uint<20> words[16];
  for (int i = 0; i < 16; ++i) words[i] = in[i];
  for (int i = 1; i < 16; ++i) out[i] = words[15 - i](8, 0);
  ap_int<12> last = in[15];
  out[0] = last + 1;
  out[3] = -5;
}
