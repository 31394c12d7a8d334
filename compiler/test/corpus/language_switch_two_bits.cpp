// A switch that LLVM narrows to the two bits that tell: its labels are numbers of two bits, the quotient is wider.
// top: language_switch_two_bits
// calls: 40
#include "ap_int.h"
int language_switch_two_bits(int number, int value) {
  ap_int<23> divisor = ap_int<36>(ap_uint<21>(1000000) / (ap_uint<11>(number) | ap_uint<11>(1)));
  switch (-(int)((unsigned short)26005 / (((unsigned short)divisor.to_int64() & 63) + 1)) & 3) {
    case 0:
    case 1: return value;
    case 2: return value + 3;
    default: return 0;
  }
}
