#include <cstdlib>
int heap_malloc(int n) {
  int* p = static_cast<int*>(malloc(32));
  p[n & 7] = n;
  return p[n & 3];
}
// error: 3:30: 'malloc' needs a heap, which hardware lacks; use an array of fixed size
