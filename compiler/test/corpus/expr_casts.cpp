// Narrowing and sign-changing casts.
// top: expr_casts
int expr_casts(int a) { return (signed char)a + (unsigned char)(a >> 4) - (short)(a * 3); }
