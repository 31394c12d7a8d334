// ap_utils.h and hls_print.h leave nothing in hardware.
// top: library_utilities
#include "ap_utils.h"
#include "hls_print.h"
ap_uint<12> library_utilities(ap_uint<12> a) {
  ap_wait();
  hls::print("a is %d\n", a.to_int());
  ap_wait_n(3);
  return a * 3;
}
