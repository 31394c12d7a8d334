// Greatest common divisor: a loop of unknown length.
// top: textbook_gcd
unsigned short textbook_gcd(unsigned short a, unsigned short b) {
  while (b != 0) {
    unsigned short t = a % b;
    a = b;
    b = t;
  }
  return a;
}
