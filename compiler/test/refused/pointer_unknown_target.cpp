int pointer_unknown_target(const int* base, int n) {
  const int* p = base;
  while (*p != n) p += *p & 3;
  return static_cast<int>(p - base);
}
// error: 1:5: the size of 'base' is not known; declare it as an array, base[64], or give INTERFACE port=base a depth
