// constexpr and default arguments.
// top: call_default_constexpr
constexpr int power(int b, int e) { return e == 0 ? 1 : b * power(b, e - 1); }
static int mix(int a, int k = power(3, 5)) { return a * k; }
int call_default_constexpr(int a) { return mix(a) + mix(a, 7); }
