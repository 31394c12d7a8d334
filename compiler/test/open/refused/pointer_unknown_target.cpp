int pointer_unknown_target(const int* base, int n) {
  const int* p = base;
  while (*p != n) p += *p & 3;
  return static_cast<int>(p - base);
}
