#include "volatile_numbers.h"

int main() {
  ap_uint<20> in[16];
  ap_int<9> out[16];
  for (int i = 0; i < 16; ++i) in[i] = 70001 * i;
  volatile_numbers(in, out);
  for (int i = 1; i < 16; ++i)
    if (i != 3 && out[i] != ap_int<9>(70001 * (15 - i))) return 1;
  return out[0] != ap_int<9>(70001 * 15 + 1) || out[3] != -5;
}
