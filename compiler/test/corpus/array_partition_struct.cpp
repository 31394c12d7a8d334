// An array of structs with arrays, split by element: the members' own arrays stay whole.
// top: array_partition_struct
// calls: 3
// expect: memory c_2 registers 3x16 count=6
#include "ap_int.h"
struct Cell { bool on; ap_int<11> x; short part[3]; };
void array_partition_struct(const int in[24], int out[24], unsigned s) {
  Cell c[6];
#pragma HLS ARRAY_PARTITION variable=c complete dim=1
  for (int i = 0; i < 6; ++i) {
    c[i].on = in[i] & 1;
    c[i].x = in[i + 6];
    for (int k = 0; k < 3; ++k) c[i].part[k] = in[i + 6 * k + 6];
  }
  for (int i = 5; i > 0; --i) {
#pragma HLS UNROLL
    c[i] = c[i - 1];
  }
  c[s % 6].x += 5;
  c[s % 6].part[s % 3] -= 5;
  for (int i = 0; i < 6; ++i) {
    out[i] = c[i].on ? int(c[i].x) : -1;
    out[i + 6] = c[(i + s) % 6].part[i % 3];
    out[i + 12] = c[(i + s) % 6].x;
    out[i + 18] = c[5 - i].part[(i + s) % 3];
  }
}
