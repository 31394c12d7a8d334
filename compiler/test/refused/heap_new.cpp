int heap_new(int n) {
  int* p = new int[8];
  p[n & 7] = n;
  int r = p[0];
  delete[] p;
  return r;
}
// error: 2:12: 'new' needs a heap, which hardware lacks; use an array of fixed size
