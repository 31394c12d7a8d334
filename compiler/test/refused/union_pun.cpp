union Bits {
  float f;
  unsigned u;
};
unsigned union_pun(float x) {
  Bits b;
  b.f = x;
  return b.u;
}
// error: the parameters of 'union_pun' have no hardware form; use integers, ap types, structs, arrays of known size and hls::stream references
