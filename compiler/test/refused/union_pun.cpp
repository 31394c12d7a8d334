union Bits {
  float f;
  unsigned u;
};
unsigned union_pun(float x) {
  Bits b;
  b.f = x;
  return b.u;
}
