// Native integers of mixed sign and width in one expression.
// top: expr_add_mixed_sign
int expr_add_mixed_sign(short a, unsigned char b, int c) { return a + b - c; }
