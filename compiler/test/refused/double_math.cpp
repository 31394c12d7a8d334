#include <cmath>
int double_math(int x) { return static_cast<int>(sqrt(static_cast<double>(x))); }
// error: 2:75: floating point has no operators yet; use ap_fixed
