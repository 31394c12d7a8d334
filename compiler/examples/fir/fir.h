/// Eight-tap low-pass filter, Q1.15 samples and coefficients.
#include "ap_fixed.h"

typedef ap_fixed<16, 1, AP_RND, AP_SAT> sample_t;

const int kTaps = 8;

/// The filtered value of the newest sample.
sample_t fir(sample_t sample);
