// hls::vector: operators on all elements at once, in arrays outside.
// top: library_vector
#include "hls_vector.h"
typedef hls::vector<int, 4> int4;
void library_vector(const int4 a[8], const int4 b[8], int4 out[8]) {
  for (int i = 0; i < 8; ++i) {  // expect: loop II=1
#pragma HLS PIPELINE II=1
    int4 sum = a[i] * b[i] + int4(3);
    sum[0] = sum.reduce_add();
    out[i] = sum ^ a[i];
  }
}
