// A C source.
// top: language_c
#include <stdint.h>
struct pair {
  int16_t low, high;
};
int32_t language_c(struct pair p, const int32_t table[8]) {
  int32_t sum = p.low * 3 - p.high;
  for (int i = 0; i < 8; i++) sum += table[i] >> i;
  return sum;
}
