// && and || evaluate their right side only when needed.
// top: expr_short_circuit
// range: d=-3..3
bool expr_short_circuit(int n, int d) { return (d != 0 && n / d > 2) || (d < 0 && n % 3 == 0); }
