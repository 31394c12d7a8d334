// Shifts by run-time amounts, arithmetic and logic.
// top: expr_shift_variable
// range: s=0..31
int expr_shift_variable(int a, unsigned b, unsigned s) { return (a >> s) ^ (int)(b >> s) ^ (a << s); }
