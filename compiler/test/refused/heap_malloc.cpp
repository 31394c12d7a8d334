#include <cstdlib>
int heap_malloc(int n) {
  int* p = static_cast<int*>(malloc(32));
  p[n & 7] = n;
  return p[n & 3];
}
