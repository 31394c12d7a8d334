// A member of an array outside that is only copied to where nobody reads it has no port.
// top: array_struct_port_unused
#include "ap_int.h"
struct Sample {
  short left;
  ap_int<11> right;
};
int array_struct_port_unused(const Sample in[16], unsigned char at) {
  Sample copy[8];
  for (int i = 0; i < 8; ++i) {
    copy[i].left = in[i].left;
    copy[i].right = in[i + 8].right;
  }
  for (int i = 7; i > 0; --i) {
    copy[i].left = copy[i - 1].left;
    copy[i].right = copy[i - 1].right;
  }
  return copy[at & 7].left;
}
