// assert() states what is true on its own path only; printing is left out.
// top: language_assert
#include <cassert>
int language_assert(const int a[16], int n) {
  int sum = 0, limit = n & 15;
LOOP:
  for (int i = 0; i < 16; ++i) {
    if (i < limit) {
      assert(limit > i);
      sum += a[i];
    } else {
      sum -= 1;
    }
  }
  return sum;
}
