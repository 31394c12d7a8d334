int heap_new(int n) {
  int* p = new int[8];
  p[n & 7] = n;
  int r = p[0];
  delete[] p;
  return r;
}
