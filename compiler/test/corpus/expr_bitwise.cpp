// Bitwise operators and complements.
// top: expr_bitwise
unsigned expr_bitwise(unsigned a, unsigned b) { return (a & ~b) | (~a ^ (b << 3)); }
