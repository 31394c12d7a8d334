// A static scalar across calls.
// top: state_scalar
// calls: 12
unsigned state_scalar(unsigned in) {
  static unsigned lfsr = 0xACE1u;
  unsigned bit = ((lfsr >> 0) ^ (lfsr >> 2) ^ (lfsr >> 3) ^ (lfsr >> 5)) & 1u;
  lfsr = (lfsr >> 1) | (bit << 15);
  return lfsr ^ in;
}
