/// Feeds a step and checks the answer against the sums of the coefficients.
#include <cmath>
#include <cstdio>

#include "fir.h"

int main() {
  const double coefficients[kTaps] = {0.0156, 0.0547, 0.1562, 0.2734, 0.2734, 0.1562, 0.0547, 0.0156};
  double expected = 0;
  for (int n = 0; n < 12; ++n) {
    if (n < kTaps) expected += 0.5 * coefficients[n];
    double got = fir(0.5).to_double();
    if (std::fabs(got - expected) > 1e-3) {
      std::printf("sample %d is %f, not %f\n", n, got, expected);
      return 1;
    }
  }
  return 0;
}
