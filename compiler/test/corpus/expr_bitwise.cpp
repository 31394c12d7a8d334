// Bitwise operators and complements.
// top: expr_bitwise
// expect: latency 2
unsigned expr_bitwise(unsigned a, unsigned b) { return (a & ~b) | (~a ^ (b << 3)); }
