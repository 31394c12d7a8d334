// memcpy and memset of a number of elements that is known at run time only.
// top: language_memcpy_variable
// range: n=0..24
#include <string.h>
void language_memcpy_variable(int n, const int in[24], short out[24], int copy[24]) {
  int buffer[24];
  int i;
  memset(buffer, 0, sizeof(buffer));
  memcpy(buffer, in, n * sizeof(int));
  for (i = 0; i < 24; i++) out[i] = buffer[i] >> 3;
  memcpy(copy, buffer + 2, 20 * sizeof(int));
  memset(copy, 0, n * sizeof(int));
}
