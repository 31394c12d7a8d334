// Division by a negative constant and by a run-time negative value.
// top: expr_negative_divisor
// range: b=-50..-1
int expr_negative_divisor(int a, int b) { return a / -3 + a % -5 + a / b; }
