union Bits {
  float f;
  unsigned u;
};
unsigned union_pun(float x) {
  Bits b;
  b.f = x;
  return b.u;
}
// error: 5:26: 'float' has no operators in hardware yet; use ap_fixed<W, I>
