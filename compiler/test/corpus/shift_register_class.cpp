// ap_shift_reg.
// top: shift_register_class
#include "ap_shift_reg.h"
int shift_register_class(int in) {
  static ap_shift_reg<int, 4> line;
  int oldest = line.shift(in, 3);
  return oldest + line.read(1);
}
