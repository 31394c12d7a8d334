// Bits and slices added to a native integer.
// top: apint_bit_sum
#include "ap_int.h"
int apint_bit_sum(ap_uint<100> word) {
  int ones = 0;
  for (int i = 0; i < 100; ++i) ones += word[i];
  ones -= word[3];
  ones += word.range(99, 90);
  ones |= (word.range(1, 0), word.range(3, 2));
  return ones;
}
