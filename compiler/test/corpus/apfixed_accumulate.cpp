// An accumulator of mixed formats over an array.
// top: apfixed_accumulate
#include "ap_fixed.h"
ap_fixed<20, 8> apfixed_accumulate(const ap_fixed<9, 2> x[16]) {
  ap_fixed<20, 8> sum = 0;
SUM:
  for (int i = 0; i < 16; ++i) sum += x[i] * ap_fixed<6, 1>(0.40625);
  return sum;
}
