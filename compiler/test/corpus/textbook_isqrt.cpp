// Integer square root, bit by bit.
// top: textbook_isqrt
unsigned textbook_isqrt(unsigned v) {
  unsigned root = 0, bit = 1u << 30;
  while (bit > v) bit >>= 2;
  while (bit) {
    if (v >= root + bit) {
      v -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
    bit >>= 2;
  }
  return root;
}
