#include <cmath>
int double_math(int x) { return static_cast<int>(sqrt(static_cast<double>(x))); }
