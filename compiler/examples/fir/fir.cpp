#include "fir.h"

static const sample_t kCoefficients[kTaps] = {0.0156, 0.0547, 0.1562, 0.2734, 0.2734, 0.1562, 0.0547, 0.0156};

sample_t fir(sample_t sample) {
  static sample_t line[kTaps];
  ap_fixed<36, 5> sum = 0;
TAP:
  for (int i = kTaps - 1; i >= 0; --i) {
    line[i] = i == 0 ? sample : line[i - 1];
    sum += line[i] * kCoefficients[i];
  }
  return sum;
}
