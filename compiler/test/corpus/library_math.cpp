// hls_math.h on integers and fixed-point numbers.
// top: library_math
#include "hls_math.h"
struct Results {
  ap_fixed<16, 8> root, magnitude, down, up, nearest;
  ap_uint<16> whole_root;
  int magnitude_of_int;
};
void library_math(ap_fixed<16, 8> x, ap_uint<32> n, int a, Results& out) {
  out.root = hls::sqrt(x);
  out.magnitude = hls::abs(x);
  out.down = hls::floor(x);
  out.up = hls::ceil(x);
  out.nearest = hls::round(x);
  out.whole_root = hls::sqrt(n);
  out.magnitude_of_int = hls::max(hls::abs(a), hls::min(a, 77));
}
