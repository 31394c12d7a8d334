#include "axilite_arguments.h"

int main() {
  int sum = 5, expected_sum = 5;
  long long big[6], expected_big[6];
  char flags[7], expected_flags[7];
  for (int i = 0; i < 6; ++i) expected_big[i] = big[i] = i * 1234567891234LL - 99;
  for (int i = 0; i < 7; ++i) expected_flags[i] = flags[i] = i * 40;
  for (int call = 0; call < 5; ++call) {
    short in[10];
    for (int i = 0; i < 10; ++i) in[i] = call * 100 - i * 37;
    const ap_uint<37> wide = (1ULL << 36) + call * 77777;
    ap_int<12> last = 0;
    axilite_arguments(in, wide, flags, big, &sum, last);
    for (int i = 0; i < 7; ++i) expected_flags[i] += in[i];
    for (int i = 0; i < 6; ++i) expected_big[i] = expected_big[i] * 3 + (long long)wide;
    expected_sum += in[9];
    for (int i = 0; i < 7; ++i)
      if (flags[i] != expected_flags[i]) return 1;
    for (int i = 0; i < 6; ++i)
      if (big[i] != expected_big[i]) return 1;
    if (sum != expected_sum || last != ap_int<12>(in[8])) return 1;
  }
  return 0;
}
