// Scalars of several widths and arrays of several element sizes in a bank of registers.
#include "axilite_arguments.h"

void axilite_arguments(const short in[10], ap_uint<37> wide, char flags[7], long long big[6], int* sum,
                       ap_int<12>& last) {
#pragma HLS INTERFACE s_axilite port=in
#pragma HLS INTERFACE s_axilite port=wide
#pragma HLS INTERFACE s_axilite port=flags
#pragma HLS INTERFACE s_axilite port=big
#pragma HLS INTERFACE s_axilite port=sum
#pragma HLS INTERFACE s_axilite port=last
#pragma HLS INTERFACE s_axilite port=return
  for (int i = 0; i < 7; i++) flags[i] = flags[i] + in[i];
  for (int i = 0; i < 6; i++) big[i] = big[i] * 3 + (long long)wide;
  *sum += in[9];
  last = in[8];
}
