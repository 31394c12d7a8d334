// Multiplication by constants becomes shifts and additions.
// top: expr_multiply_constant
int expr_multiply_constant(int a) { return a * 245 + a * 10 - a * -7; }
