// 64-bit product of 32-bit operands.
// top: expr_multiply_wide
// expect: operators multiply=1
long long expr_multiply_wide(int a, int b) { return (long long)a * b; }
