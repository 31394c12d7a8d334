#include "ap_int.h"

void calls_of_sums(ap_uint<8> value, bool clear, ap_uint<16>* sum, bool* is_odd);

int main() {
  unsigned total = 0;
  for (unsigned call = 0; call < 100; ++call) {
    const unsigned value = call * 37 & 0xff;
    const bool clear = call % 11 == 5;
    total = (clear ? value : total + value) & 0xffff;
    ap_uint<16> sum = 0;
    bool is_odd = false;
    calls_of_sums(value, clear, &sum, &is_odd);
    if (sum != (total * value & 0xffff) || is_odd != (total & 1)) return 1;
  }
  return 0;
}
