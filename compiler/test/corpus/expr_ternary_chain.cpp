// Nested conditional expressions.
// top: expr_ternary_chain
int expr_ternary_chain(int a, int b, int c) { return a < b ? (b < c ? c : b) : (a < c ? c : a); }
