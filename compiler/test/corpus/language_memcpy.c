// memcpy and memset of whole arrays, in C.
// top: language_memcpy
#include <string.h>
void language_memcpy(const unsigned a[64], unsigned b[64]) {
  unsigned kept[64];
  memcpy(kept, a, sizeof(kept));
  memset(b, 0, 64 * sizeof(unsigned));
  for (int i = 0; i < 64; i += 2) b[i] = kept[63 - i] + 1;
}
