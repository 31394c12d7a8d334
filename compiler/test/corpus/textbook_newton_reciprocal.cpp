// Reciprocal by Newton's iteration in integers.
// top: textbook_newton_reciprocal
// range: d=32768..65535
unsigned textbook_newton_reciprocal(unsigned short d) {
  unsigned x = 48u * 65536u / 17u - (unsigned)(((unsigned long long)d * (32u * 65536u / 17u)) >> 16);
  for (int i = 0; i < 3; ++i) {  // expect: loop II=3
    unsigned e = (unsigned)(((unsigned long long)x * d) >> 16);
    x = (unsigned)(((unsigned long long)x * (131072u - e)) >> 16);
  }
  return x;
}
